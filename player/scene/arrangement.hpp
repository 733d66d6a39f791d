#pragma once

#include "player/layout/layout.hpp"
#include "player/layout/plan/plan_request.hpp"
#include "player/scene/files/shot_rotation.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct WallShot;

/// A shot on the wall, its slot, and its place.
struct SlotShot {
    int slot = 0;  // on a panning wall: the position from the left, which changes as the wall moves
    ShotKey key;
    std::string folder = {};  // the folder that it stands for, with others; empty: it is an entry itself
    Placement at = {};
    Seat seat = {};  // of its I-Region; without area: a panning wall keeps no places

    bool operator==(const SlotShot&) const = default;
};

/// A wall as it was, so that it can be shown again.
struct ArrangedWall {
    Vec2 canvas;  // px
    std::vector<SlotShot> shots;

    bool operator==(const ArrangedWall&) const = default;
};

/// The shot that an arrangement has in a slot, as the slots know it: a folder stands for its shots.
/// None: it has none.
std::optional<ShotKey> arranged_key(const ArrangedWall& wall, int slot);

/// Gives the items of a plan their places in an arrangement. An item that is new in its slot takes over a
/// seat there.
/// @param wanted  the shots of the items
/// @param canvas  px; on a canvas of another shape the items keep no places
void give_arranged_places(std::span<PlanItem> items, std::span<const WallShot> wanted,
                          const ArrangedWall& wall, Vec2 canvas);

}  // namespace vitrine::player
