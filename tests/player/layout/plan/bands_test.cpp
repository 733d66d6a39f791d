#include "player/layout/plan/bands.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/banded_edits.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("no region is under a bezel, in a plan of one item or of many") {
    for (const std::size_t count : {1, 2, 5, 9})
        for (const double gap : {1, 40, 700}) {
            const PlanRequest request = random_request_on(two_outputs({640, 360}, gap), count, count);
            const Layout layout = plan(request);
            CHECK(is_clear_of_bands(request, layout.placements));
            CHECK(is_sound(items_of(request), layout, "bands"));
        }
}

TEST_CASE("without its bands the same wall has regions across the middle") {
    int across = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        PlanRequest request = random_request_on(two_outputs({640, 360}, 40), 5, seed);
        const Canvas canvas = std::exchange(request.canvas, Canvas(Vec2(request.canvas)));
        const Layout layout = plan(request);
        request.canvas = canvas;
        across += is_clear_of_bands(request, layout.placements) ? 0 : 1;
    }
    CHECK(across >= 4);
}

TEST_CASE("an item that stood where a bezel now is moves to an output") {
    PlanRequest request = random_request_on(Canvas(1320, 360), 4, 3);
    const Layout before = plan(request);
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].previous = before.placements[i];
    request.canvas = two_outputs({640, 360}, 40);
    CHECK(is_clear_of_bands(request, plan(request).placements));
}

// `long` makes 10,000 (many_bands_test).
TEST_CASE("no region rests under a bezel after any of many random plans and edits") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        BandedEdits edits(seed);
        for (int k = 0; k < 12; ++k) {
            const auto fault = edits.step();
            CAPTURE(seed);
            REQUIRE_MESSAGE(!fault, *fault);
        }
    }
}
