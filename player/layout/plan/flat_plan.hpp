#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// The plan of items on one canvas; groups do not count. See plan.hpp for what holds in every layout.
///
/// The paper's energy: initial packing, then eq. 3.4 descended. Else, where nothing stands or all that stands
/// is pinned: initial packing, then growing and separating. Else kept items move as little as possible:
/// newcomers enter at their seat or where most room is, and only what is in their way makes room. At last,
/// unless the request says otherwise, the gaps are filled (pack/filling.hpp).
Layout plan_flat(const PlanRequest& request, const PlanWatch& watch = {});

/// The same for a wall some of whose items stand, without ever packing it anew.
/// @return none where nothing stands, or where pinned items leave no room
std::optional<Layout> plan_change(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
