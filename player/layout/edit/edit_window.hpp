#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

// On a large wall an edit affects only a window around it. Items completely inside the window may move. Items
// across its edge are pinned. Items outside cannot be touched by those inside. On a small wall the window is
// the whole wall.

/// True if a box lies inside another, within a tolerance in px.
bool is_box_within(const Box& inner, const Box& outer, double tolerance = 0);

/// The box of a placed item's region, canvas px.
Box box_of(const LayoutItem& item, const Placement& at);

/// The placement, moved so that its region lies inside the canvas, if the region is small enough.
/// @param margin  canvas px between the region and the canvas' edge
Placement moved_inside(const LayoutItem& item, Placement at, Vec2 canvas, double margin);

/// The window of an edit at a place, canvas px: the whole wall if it is small, else large enough that some
/// items can make room.
Box window_at(const WallState& wall, Vec2 place, const EditRules& rules);

/// Plans the items in the window; all others stay.
/// @return none: there is no room
std::optional<Layout> planned_in(const Box& window, const PlanRequest& request, const PlanWatch& watch);

}  // namespace vitrine::player
