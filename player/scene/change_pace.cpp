#include "player/scene/change_pace.hpp"

#include "player/scene/wall_cells.hpp"

namespace vitrine::player {

bool is_too_small_to_flash(std::span<const PlacedShot> shown, std::span<const PlacedShot> incoming,
                           Vec2 canvas) {
    constexpr int columns = 32, rows = 18;  // points of the canvas that are looked at
    constexpr double flashing_share = 0.25;
    const auto shot_at = [](std::span<const PlacedShot> wall, Vec2 point) {
        const PlacedShot* shot = find_shot_at(wall, point);
        return shot == nullptr ? SourceId{0} : shot->shot.source;
    };
    int changed = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const Vec2 point{(x + 0.5) * canvas.x / columns, (y + 0.5) * canvas.y / rows};
            if (shot_at(shown, point) != shot_at(incoming, point)) ++changed;
        }
    return changed < flashing_share * columns * rows;
}

}  // namespace vitrine::player
