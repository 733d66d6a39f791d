#include "player/layout/plan/plan.hpp"

#include "player/layout/plan/flat_plan.hpp"
#include "player/layout/plan/nesting.hpp"

#include <algorithm>

namespace vitrine::player {

Layout plan(const PlanRequest& request, const PlanWatch& watch) {
    const bool has_groups = std::any_of(request.items.begin(), request.items.end(), [](const PlanItem& item) {
        return item.group != PlanItem::no_group;
    });
    return has_groups ? plan_nested(request, watch) : plan_flat(request, watch);
}

}  // namespace vitrine::player
