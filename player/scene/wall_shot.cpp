#include "player/scene/wall_shot.hpp"

#include "player/layout/layout.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

WallShot wall_shot(const MediaRecord& record, const ShotKey& key, SourceId source, int slot) {
    const Shot& shot = record.shots.at(static_cast<std::size_t>(key.shot));
    return {.source = source,
            .slot = slot,
            .key = key,
            .kind = record.kind,
            .picture = {static_cast<double>(record.width), static_cast<double>(record.height)},
            .active = active_picture(record, shot),
            .item = layout_item(record, shot),
            .shot = shot,
            .folder = {}};
}

ShotRequest request_of(const PlacedShot& placed) {
    const WallShot& shot = placed.shot;
    const double scale = std::min(1.0, placed.placement.scale);
    return {.source = shot.source,
            .path = shot.key.path,
            .kind = shot.kind,
            .shot = shot.shot,
            .width = std::max(1, static_cast<int>(std::lround(shot.picture.x * scale))),
            .height = std::max(1, static_cast<int>(std::lround(shot.picture.y * scale)))};
}

const PlacedShot* find_source(std::span<const PlacedShot> wall, SourceId source) {
    const auto found =
        std::ranges::find(wall, source, [](const PlacedShot& placed) { return placed.shot.source; });
    return found == wall.end() ? nullptr : &*found;
}

const PlacedShot* find_slot(std::span<const PlacedShot> wall, int slot) {
    const auto found =
        std::ranges::find(wall, slot, [](const PlacedShot& placed) { return placed.shot.slot; });
    return found == wall.end() ? nullptr : &*found;
}

std::vector<ShotRequest> update_stored(std::span<PlacedShot> wall, std::span<const WallShot> known) {
    std::vector<ShotRequest> changed;
    for (PlacedShot& placed : wall) {
        const auto now = std::ranges::find(known, placed.shot.source, &WallShot::source);
        if (now == known.end() || now->shot.stored == placed.shot.shot.stored) continue;
        placed.shot.shot.stored = now->shot.stored;
        changed.push_back(request_of(placed));
    }
    return changed;
}

}  // namespace vitrine::player
