#pragma once

#include "base/state/record.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/layout/plan/plan_request.hpp"
#include "player/scene/files/group_turns.hpp"
#include "player/scene/files/shot_rotation.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// A shot that has a slot on the wall, with all data for showing it: it outlives its record.
struct WallShot {
    SourceId source = 0;
    int slot = 0;
    ShotKey key;
    MediaKind kind = MediaKind::photo;
    Vec2 picture;  // size of the upright picture, source px
    Box active;    // its part within its bars, source px
    LayoutItem item;
    Shot shot;
    std::optional<std::chrono::sys_time<std::chrono::milliseconds>> taken;  // by a camera
    std::string folder;  // the folder whose entry it stands for, with others; empty: it is an entry itself
    std::shared_ptr<const WallShot> film{};  // that belongs to a photo, without a source; null: none

    bool operator==(const WallShot&) const = default;
};

/// @param key  a shot of this record
WallShot wall_shot(const MediaRecord& record, const ShotKey& key, SourceId source, int slot);

/// The film that belongs to a photo, without a source: the one inside its file, whose key is the photo's, or
/// that of a Live Photo. Null: there is none.
std::shared_ptr<const WallShot> film_of_photo(const RecordList& files, const GroupTurns& groups,
                                              const ShotKey& photo);

/// The facts of a shot of the wall as its file's record has them now.
const Shot& shot_now(const MediaRecord& record, const WallShot& shot);

/// The group of a shot in a layout, by its slot: the shots of one folder are placed together.
inline int group_of(const WallShot& shot) {
    return shot.folder.empty() ? PlanItem::no_group : shot.slot;
}

/// The way on which a photo moves slowly inside its cell, from `from` through its place to `to` and back.
/// Canvas px, relative to the place of its layout. Both are 0 where it does not move.
struct PhotoDrift {
    Vec2 from;
    Vec2 to;
};

/// A shot at its place on the canvas.
struct PlacedShot {
    WallShot shot;
    Placement placement;
    std::shared_ptr<const Cell> cell;   // shared with the frames under way
    std::chrono::nanoseconds began{0};  // time of its first appearance; `never`: not yet
    int group = PlanItem::no_group;     // shots of one group are placed together
    PhotoDrift drift = {};
    bool is_above = false;  // its cell lies above those of the others, as the shot is in a hand
};

constexpr std::chrono::nanoseconds never = std::chrono::nanoseconds::max();

/// Returns the time since a shot first appeared. Before that, the time is 0.
std::chrono::nanoseconds seen_for(const PlacedShot& placed, std::chrono::nanoseconds now);

/// The request for a shot's source at its present size, without more pixels than are shown.
ShotRequest request_of(const PlacedShot& placed);

/// The shot with this source; nullptr if the wall has none.
const PlacedShot* find_source(std::span<const PlacedShot> wall, SourceId source);

/// The shot in this slot; nullptr if the wall has none.
const PlacedShot* find_slot(std::span<const PlacedShot> wall, int slot);

/// Updates the shots' places in the store.
/// @param known  the shots from the present records
/// @return       requests for the shots whose place in the store has changed
std::vector<ShotRequest> update_stored(std::span<PlacedShot> wall, std::span<const WallShot> known);

}  // namespace vitrine::player
