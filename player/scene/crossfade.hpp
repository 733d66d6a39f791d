#pragma once

#include "player/layout/plan/plan_request.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/wall_slots.hpp"

#include <chrono>
#include <memory>
#include <span>

namespace vitrine::player {

/// A shot where it stands.
struct PlacedShot {
    WallShot shot;
    Placement placement;
    std::shared_ptr<const Cell> cell;   // shared: with the frames under way
    std::chrono::nanoseconds began{0};  // when it first appeared; `never`: it has not yet
    int group = PlanItem::no_group;     // those of one stand together
};

constexpr std::chrono::nanoseconds never = std::chrono::nanoseconds::max();

/// What a shot's source is asked for where it stands: no more pixels than are shown.
ShotRequest request_of(const PlacedShot& placed);

/// How far the subject has moved in a shot that loops, source px; 0 for a photo.
Vec2 slide(const Shot& shot, std::chrono::nanoseconds local);

/// A transition's progress in [0, 1] eased in and out; clamps.
double eased(double progress);

/// The draw list of a moment: the old wall whole and the new one over it, or either alone. No wall is the
/// idle picture. Where nothing changes between the two walls the new one is not drawn a second time.
///
/// @param progress  of the transition: 0: only the old wall, 1: only the new one
Frame compose(Vec2 canvas, std::span<const PlacedShot> old_wall, std::span<const PlacedShot> new_wall,
              double progress, std::chrono::nanoseconds now);

/// The draw list of a moment in which the shots of the first wall fade in over the idle picture, each from
/// when it appeared.
Frame arriving(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds crossfade,
               std::chrono::nanoseconds now);

}  // namespace vitrine::player
