#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <optional>

namespace vitrine::player {

/// The layout of a request that keeps its places: each item where it was. None: an item has no place, or the
/// places are not sound any more, such as after a film was analysed anew. Sound are places at which no two
/// I-Regions overlap, none lies under a band or beyond the canvas, and no two hulls of groups overlap.
std::optional<Layout> kept_layout(const PlanRequest& request);

}  // namespace vitrine::player
