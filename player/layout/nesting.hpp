#pragma once

#include "player/layout/plan.hpp"

namespace vitrine {

/// Where every item shall stand when those of one group stand together: each group is packed by itself, then
/// counts as one item whose region is the hull of its regions, and takes them along where it goes. The layout
/// names the groups. A group of one is an item by itself. Source: Dynamic Media Assemblage, future work
/// (hierarchies of media).
Layout plan_nested(const PlanRequest& request, const PlanWatch& watch = {});

/// plan(), or plan_nested() where items stand in groups.
Layout planned(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine
