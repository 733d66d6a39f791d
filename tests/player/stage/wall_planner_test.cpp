#include "player/stage/wall_planner.hpp"

#include "player/layout/plan/plan.hpp"
#include "player/stage/stage_settings.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <thread>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{640, 360};

WallPlan wall_plan(std::uint64_t generation, int items) {
    WallPlan wall{.generation = generation, .canvas = canvas, .items = {}};
    for (int i = 0; i < items; ++i)
        wall.items.push_back({.item = {.region = to_polygon({{200, 100}, {320.0 + 10 * i, 220}}),
                                       .core = {{0, 0}, {640, 360}}}});
    return wall;
}

std::vector<Placement> planned(const Settings& settings, const WallPlan& wall) {
    PlanRequest request = plan_request(settings, wall.canvas);
    request.items = wall.items;
    return plan(request).placements;
}

/// Waits for the final layout. None: it did not come within a minute.
std::optional<Layout> final_layout(WallPlanner& planner) {
    for (const auto end = std::chrono::steady_clock::now() + 60s; std::chrono::steady_clock::now() < end;) {
        std::optional<Layout> layout = planner.pop_layout();
        if (layout && layout->is_final) return layout;
        std::this_thread::yield();
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("a planner at once has the final layout when the request returns, and gives it once") {
    const Settings settings;
    WallPlanner planner(settings, true);
    CHECK_FALSE(planner.pop_layout());
    const WallPlan wall = wall_plan(7, 3);
    planner.request_layout(wall);
    const std::optional<Layout> layout = planner.pop_layout();
    REQUIRE(layout);
    CHECK(layout->generation == 7);
    CHECK(layout->is_final);
    CHECK(layout->canvas == canvas);
    CHECK(layout->placements == planned(settings, wall));
    CHECK_FALSE(planner.pop_layout());
}

TEST_CASE("a planner at once gives the layout of the newest plan alone") {
    const Settings settings;
    WallPlanner planner(settings, true);
    planner.request_layout(wall_plan(1, 2));
    planner.request_layout(wall_plan(2, 4));
    const std::optional<Layout> layout = planner.pop_layout();
    REQUIRE(layout);
    CHECK(layout->generation == 2);
    CHECK(layout->placements.size() == 4);
    CHECK_FALSE(planner.pop_layout());
}

TEST_CASE("a planner on its thread comes to the same layout") {
    const Settings settings;
    WallPlanner planner(settings, false);
    const WallPlan wall = wall_plan(9, 3);
    planner.request_layout(wall);
    const std::optional<Layout> layout = final_layout(planner);
    REQUIRE(layout);
    CHECK(layout->generation == 9);
    CHECK(layout->placements == planned(settings, wall));
}

TEST_CASE("a change of the settings holds for the next plan") {
    Settings settings;
    settings.layout.max_enlargement = 0.25;
    WallPlanner planner(settings, true);
    const WallPlan wall = wall_plan(1, 1);
    planner.request_layout(wall);
    CHECK(planner.pop_layout()->placements.at(0).scale <= 0.25 + 1e-9);
    settings.layout.max_enlargement = 2;
    planner.request_layout(wall);
    CHECK(planner.pop_layout()->placements.at(0).scale > 0.5);
}
