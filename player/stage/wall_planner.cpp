#include "player/stage/wall_planner.hpp"

#include "player/layout/edit/wall_way.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/stage/stage_settings.hpp"

#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

/// The layout at the end of a way, with the way.
Layout layout_of(const WayRequest& request) {
    Layout layout{.canvas = request.wall.canvas, .is_final = true};
    auto way = std::make_shared<const WallWay>(way_to(request));
    layout.placements = way->keys.back().placements;
    layout.way = std::move(way);
    return layout;
}

}  // namespace

void WallPlanner::request_layout(const WallPlan& wall) {
    if (wall.way) {
        const auto make = [way = wall.way](const PlanWatch& watch) {
            WayRequest request = *way;
            request.rules.should_stop = watch.should_stop;
            return layout_of(request);
        };
        if (!is_at_once_) return planner_.request_layout(make, wall.generation);
        made_at_once_ = make({});
        made_at_once_->generation = wall.generation;
        return;
    }
    PlanRequest request = plan_request(settings_, wall.canvas);
    request.items = wall.items;
    request.keeps_places = wall.keeps_places;
    if (!is_at_once_) return planner_.request_layout(std::move(request), wall.generation);
    made_at_once_ = plan(request);
    made_at_once_->generation = wall.generation;
    made_at_once_->is_final = true;
}

std::optional<Layout> WallPlanner::pop_layout() {
    return is_at_once_ ? std::exchange(made_at_once_, std::nullopt) : planner_.pop_layout();
}

}  // namespace vitrine::player
