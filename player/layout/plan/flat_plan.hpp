#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// Plans items on one canvas; ignores groups. plan.hpp lists the properties of every layout.
///
/// With the paper's energy: initial packing, then descent of eq. 3.4. Otherwise, if no item is placed or all
/// placed items are pinned: initial packing, then growing and separating. Otherwise kept items move as little
/// as possible: newcomers enter at their seat or at the emptiest place, and only items in their way make
/// room. On a canvas with bands (bands.hpp) no I-Region comes to rest under one, whatever the search finds.
/// At last, unless the request forbids it, the gaps are filled (pack/filling.hpp).
Layout plan_flat(const PlanRequest& request, const PlanWatch& watch = {});

/// The same for a wall with placed items, without ever packing it anew.
/// @return none: no item is placed, or pinned items leave no room
std::optional<Layout> plan_change(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
