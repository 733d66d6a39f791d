#include "player/layout/plan/planner.hpp"

#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <semaphore>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// Waits for the final layout of the newest request.
Layout final_layout(Planner& planner, std::counting_semaphore<>& ready) {
    for (;;) {
        ready.acquire();
        const std::optional<Layout> layout = planner.pop_layout();
        if (layout && layout->is_final) return *layout;
    }
}

}  // namespace

TEST_CASE("the planner's last layout is the plan of the request") {
    std::counting_semaphore<> ready(0);
    Planner planner([&] { ready.release(); });
    const PlanRequest request = random_request(6, 3);
    planner.request_layout(request, 7);
    const Layout layout = final_layout(planner, ready);
    CHECK(layout.generation == 7);
    CHECK(layout.placements == plan(request).placements);
}

TEST_CASE("only layouts of the newest request are handed out") {
    std::counting_semaphore<> ready(0);
    Planner planner([&] { ready.release(); });
    for (std::uint64_t k = 1; k <= 30; ++k) {
        planner.request_layout(random_request(3 + k % 5, k), k);
        const std::optional<Layout> layout = planner.pop_layout();
        if (layout) CHECK(layout->generation == k);
    }
    const Layout layout = final_layout(planner, ready);
    CHECK(layout.generation == 30);
    CHECK(layout.placements.size() == 3 + 30 % 5);
}

TEST_CASE("a planner at work can be destroyed") {
    for (int k = 0; k < 5; ++k) {
        Planner planner;
        PlanRequest request = random_request(12, 1);
        request.budget = 1'000'000'000'000;
        planner.request_layout(std::move(request), 1);
    }
    Planner idle;
    CHECK_FALSE(idle.pop_layout());
}
