#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

// On a large wall only a window round an edit takes part in it: items wholly inside may move, items across
// its edge are pinned, and items outside cannot be met by those that stay inside. A small wall is one window.

/// True where a box lies in another, within a tolerance in px.
bool is_box_within(const Box& inner, const Box& outer, double tolerance = 0);

/// The box of a placed item's region, canvas px.
Box box_of(const LayoutItem& item, const Placement& at);

/// The window of an edit at a place, canvas px: all of a small wall; else large enough that some items can
/// give way.
Box window_at(const WallState& wall, Vec2 place, const EditRules& rules);

/// The same window with the items that a drag has displaced, and with their homes.
Box with_displaced(const WallState& wall, Box window);

/// The emptiest place of a wall, for a newcomer without a wish, canvas px.
Vec2 emptiest_place(const WallState& wall, const EditRules& rules);

/// Plans the items in the window; all others stay.
/// @return none where there is no room
std::optional<Layout> planned_in(const Box& window, const PlanRequest& request, const PlanWatch& watch);

}  // namespace vitrine::player
