#pragma once

#include "player/layout/edit/wall_state.hpp"
#include "player/layout/plan/plan.hpp"

#include <optional>

namespace vitrine::player {

// On a large wall only a window round an edit takes part in it: what lies wholly in it may move, what crosses
// its edge is pinned, and what lies outside cannot be met by what stays inside. A small wall is one window.

/// Whether a box lies in another, within a tolerance in px.
bool is_within(const Box& inner, const Box& outer, double tolerance = 0);

/// The box of an item's region where it stands, canvas px.
Box box_of(const LayoutItem& item, const Placement& at);

/// The window of an edit at a place, canvas px.
Box window_at(const Standing& wall, Vec2 place, const EditRules& rules);

/// The same window with all that a drag has displaced, and where it goes back to.
Box with_displaced(const Standing& wall, Box window);

/// Where the wall is emptiest, for a newcomer without a wish, canvas px.
Vec2 emptiest_place(const Standing& wall, const EditRules& rules);

/// Plans what lies in the window; everything else stays.
/// @return none where there is no room
std::optional<Layout> planned_in(const Box& window, const PlanRequest& request, const PlanWatch& watch);

}  // namespace vitrine::player
