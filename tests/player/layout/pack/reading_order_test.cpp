#include "player/layout/pack/reading_order.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/shape.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/inversions.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

bool is_sound(const PlanRequest& request, const Layout& layout) {
    const Measure measure = measured(items_of(request), layout.placements);
    return measure.hidden == 0 && measure.bounds.min.x >= 0 && measure.bounds.min.y >= 0 &&
           measure.bounds.max.x <= layout.canvas.x && measure.bounds.max.y <= layout.canvas.y;
}

}  // namespace

TEST_CASE("a violation is what must be moved, and none is left where one is before the other") {
    Random random(5);
    const ReadingOrder order{15};
    for (int round = 0; round < 1000; ++round) {
        const double x = uniform(random);
        const Vec2 later{100 * x - 50, 100 * uniform(random) - 50};
        const double violation = order.violation({0, 0}, later);
        if (violation == 0) CHECK(is_read_before({0, 0}, later, order));
        if (violation > 2 * ReadingOrder::margin) CHECK_FALSE(is_read_before({0, 0}, later, order));
        const double far = violation + 1e-6;
        const bool lowered = order.violation({0, 0}, later + Vec2{0, far}) == 0;
        const bool moved = order.violation({0, 0}, later + Vec2{far, far}) == 0;
        CHECK((lowered || moved));
    }
}

TEST_CASE("a layout to be read has no inversions, in any state on the way") {
    for (const std::size_t count : {1, 2, 3, 5, 8, 12, 24, 60})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            PlanRequest request = random_request(count, seed);
            request.order = LayoutOrder::reading;
            request.budget = 20'000;
            const std::vector<LayoutItem> items = items_of(request);
            const Layout last = plan(request, {.on_better = [&](const Layout& layout) {
                                         CHECK(inversions_of(items, layout) == 0);
                                         CHECK(is_sound(request, layout));
                                     }});
            CHECK(inversions_of(items, last) == 0);
            CHECK(is_sound(request, last));
        }
}

TEST_CASE("items replaced in a layout to be read keep the order") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        PlanRequest request = random_request(8, seed);
        request.order = LayoutOrder::reading;
        const std::vector<Placement> before = plan(request).placements;
        for (std::size_t i = 0; i < before.size(); ++i)
            request.items[i].previous = before[i];
        const Seat seat = seat_of(request.items[3].item, before[3]);
        Random random(seed + 50);
        request.items[3] = {.item = random_item(random), .seat = seat};
        const Layout after = plan(request);
        CHECK(inversions_of(items_of(request), after) == 0);
        CHECK(is_sound(request, after));
    }
}
