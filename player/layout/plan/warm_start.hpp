#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// Lays out a request some of whose items stand already: newcomers are let in, items in their way move aside,
/// the rest of the room is grown into, and everything goes back towards where it stood.
///
/// @param problem  scales in canvas px; those of kept items and of seated newcomers are set from the
/// placements
///                 and seats, held within [1/2, 2] of the natural ones
/// @return         free of overlap; none where no way was found
/// Source: docs/algorithms.md, (d) "Slots rotating". Differs: if separation fails the newcomers shrink, then
/// all.
std::optional<Arrangement> warm_start(const PlanRequest& request, PackingProblem& problem, Random& random,
                                      SearchBudget& budget);

}  // namespace vitrine::player
