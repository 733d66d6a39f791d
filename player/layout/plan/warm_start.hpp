#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// Lays out a request some of whose items stand already: newcomers are let in, what is in their way
/// moves aside, what is left over is grown into, and everything goes back towards where it stood.
///
/// @param ground  scales in canvas px; those of kept items and of seated newcomers are set from
///                what stood there, held within [1/2, 2] of the natural ones
/// @return        free of overlap; none where no way was found
/// Source: ALGORITHMS (d) "Slots rotating". Differs: if separation fails the newcomers shrink, then all.
std::optional<Arrangement> warm_start(const PlanRequest& request, Ground& ground, Random& random,
                                      Effort& effort);

}  // namespace vitrine::player
