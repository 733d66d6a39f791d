#include "player/scene/arrangement.hpp"

#include "player/scene/wall_shot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace vitrine::player {

namespace {

constexpr double same_shape = 0.01;  // largest difference of two quotients of width and height

/// The placement that takes one canvas to another of the same shape.
std::optional<Placement> change_of_canvas(Vec2 from, Vec2 to) {
    if (from.x <= 0 || from.y <= 0 || std::abs(to.x / to.y - from.x / from.y) > same_shape)
        return std::nullopt;
    const double scale = std::min(to.x / from.x, to.y / from.y);
    return Placement{scale, (to - from * scale) * 0.5};
}

}  // namespace

std::optional<ShotKey> arranged_key(const ArrangedWall& wall, int slot) {
    const auto found = std::ranges::find(wall.shots, slot, &SlotShot::slot);
    if (found == wall.shots.end()) return std::nullopt;
    return found->folder.empty() ? found->key : ShotKey{found->folder, 0};
}

void give_arranged_places(std::span<PlanItem> items, std::span<const WallShot> wanted,
                          const ArrangedWall& wall, Vec2 canvas) {
    for (PlanItem& item : items) {
        item.previous.reset();
        item.seat.reset();
    }
    const std::optional<Placement> change = change_of_canvas(wall.canvas, canvas);
    if (!change) return;
    std::set<const SlotShot*> taken;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto same = std::ranges::find_if(wall.shots, [&](const SlotShot& shot) {
            return shot.slot == wanted[i].slot && shot.key == wanted[i].key && !taken.contains(&shot);
        });
        if (same == wall.shots.end()) continue;
        items[i].previous = composed(same->at, *change);
        taken.insert(&*same);
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto seat = std::ranges::find_if(wall.shots, [&](const SlotShot& shot) {
            return shot.slot == wanted[i].slot && shot.seat.area > 0 && !taken.contains(&shot);
        });
        if (items[i].previous || seat == wall.shots.end()) continue;
        items[i].seat = Seat{seat->seat.centre * change->scale + change->offset,
                             seat->seat.area * change->scale * change->scale};
        taken.insert(&*seat);
    }
}

}  // namespace vitrine::player
