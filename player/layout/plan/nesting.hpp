#pragma once

#include "player/layout/plan/plan_request.hpp"

namespace vitrine::player {

/// Lays out the items of each group together. The canvas is divided among the groups by the weights of their
/// items, and each group is packed on its part, so that the hulls of their I-Regions never overlap. The items
/// without a group form one more group. The layout lists the groups with more than one item.
/// Source: Dynamic Media Assemblage, future work (hierarchies of media).
Layout plan_nested(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
