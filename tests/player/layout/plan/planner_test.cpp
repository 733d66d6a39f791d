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
    const std::uint64_t generation = planner.request_layout(request);
    const Layout layout = final_layout(planner, ready);
    CHECK(layout.generation == generation);
    CHECK(layout.placements == plan(request).placements);
}

TEST_CASE("only layouts of the newest request are handed out") {
    std::counting_semaphore<> ready(0);
    Planner planner([&] { ready.release(); });
    std::uint64_t newest = 0;
    for (std::uint64_t k = 0; k < 30; ++k) {
        newest = planner.request_layout(random_request(3 + k % 5, k));
        const std::optional<Layout> layout = planner.pop_layout();
        if (layout) CHECK(layout->generation == newest);
    }
    const Layout layout = final_layout(planner, ready);
    CHECK(layout.generation == newest);
    CHECK(layout.placements.size() == 3 + 29 % 5);
}

TEST_CASE("a planner at work can be destroyed") {
    for (int k = 0; k < 5; ++k) {
        Planner planner;
        PlanRequest request = random_request(12, 1);
        request.budget = 1'000'000'000'000;
        planner.request_layout(std::move(request));
    }
    Planner idle;
    CHECK_FALSE(idle.pop_layout());
}
