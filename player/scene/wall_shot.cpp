#include "player/scene/wall_shot.hpp"

#include "player/layout/layout.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

std::optional<std::chrono::sys_time<std::chrono::milliseconds>> time_of_camera(const MediaOrigin& origin) {
    if (!origin.taken || origin.taken->source == TimeSource::file) return std::nullopt;
    return origin.taken->at;
}

}  // namespace

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
            .taken = time_of_camera(record.origin),
            .folder = {},
            .film = {}};
}

std::shared_ptr<const WallShot> film_of_photo(const RecordList& files, const GroupTurns& groups,
                                              const ShotKey& photo) {
    const RecordList::Record record = files.find(photo.path);
    if (!record || record->kind != MediaKind::photo) return nullptr;
    if (record->film && record->film->is_there()) {
        const MediaRecord inner{.path = record->path,
                                .kind = MediaKind::film,
                                .width = record->film->width,
                                .height = record->film->height,
                                .shots = {record->film->shot}};
        return std::make_shared<const WallShot>(wall_shot(inner, photo, 0, 0));
    }
    const RecordList::Record film = files.find(groups.film_of(photo.path));
    if (!film) return nullptr;
    return std::make_shared<const WallShot>(wall_shot(*film, {.path = film->path, .shot = 0}, 0, 0));
}

const Shot& shot_now(const MediaRecord& record, const WallShot& shot) {
    const bool is_inner = shot.kind == MediaKind::film && record.kind == MediaKind::photo && record.film;
    return is_inner ? record.film->shot : record.shots.at(static_cast<std::size_t>(shot.key.shot));
}

std::chrono::nanoseconds seen_for(const PlacedShot& placed, std::chrono::nanoseconds now) {
    return now > placed.began ? now - placed.began : std::chrono::nanoseconds(0);
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
