#include "player/stage/wall_planner.hpp"

#include "player/layout/plan/plan.hpp"
#include "player/stage/stage_settings.hpp"

#include <utility>

namespace vitrine::player {

void WallPlanner::request_layout(const WallPlan& wall) {
    PlanRequest request = plan_request(settings_, wall.canvas);
    request.items = wall.items;
    if (!is_at_once_) return planner_.request_layout(std::move(request), wall.generation);
    made_at_once_ = plan(request);
    made_at_once_->generation = wall.generation;
    made_at_once_->is_final = true;
}

std::optional<Layout> WallPlanner::pop_layout() {
    return is_at_once_ ? std::exchange(made_at_once_, std::nullopt) : planner_.pop_layout();
}

}  // namespace vitrine::player
