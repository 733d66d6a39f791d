#pragma once

#include "player/layout/plan/flat_plan.hpp"

namespace vitrine::player {

/// Where every item shall stand when those of one group stand together: the canvas is divided among the
/// groups by what their items weigh, and each is packed on its part, so that the hulls of their I-Regions
/// never overlap. Items without a group are one too. The layout names the groups of more than one item.
/// Source: Dynamic Media Assemblage, future work (hierarchies of media).
Layout plan_nested(const PlanRequest& request, const PlanWatch& watch = {});

/// plan(), or plan_nested() where items stand in groups.
Layout planned(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
