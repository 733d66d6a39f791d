#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// Lays out a request with some placed items: newcomers are let in, items in their way move aside, all items
/// grow into the remaining room, and everything moves back towards its former place.
///
/// @param problem  scales in canvas px. Those of kept items and of seated newcomers are set from the
/// placements and seats, limited to [1/2, 2] of the natural ones; newcomers to [3/4, 2]
/// @return         free of overlap; none: no way was found
/// Source: docs/algorithms.md, (d) "Slots rotating". Differs: if separation fails, the newcomers shrink, then
/// all items.
std::optional<Arrangement> warm_start(const PlanRequest& request, PackingProblem& problem, Random& random,
                                      SearchBudget& budget);

}  // namespace vitrine::player
