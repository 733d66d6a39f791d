#include "player/layout/plan/nesting.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/layout/cells/grid.hpp"
#include "player/layout/pack/overlap.hpp"
#include "player/layout/plan/flat_plan.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// Nine items: four of one folder, three of another, two by themselves.
PlanRequest nested_request(std::uint64_t seed) {
    PlanRequest request = random_request(9, seed);
    for (std::size_t i = 0; i < 7; ++i)
        request.items[i].group = i < 4 ? 0 : 1;
    return request;
}

Polygon hull_of(const PlanRequest& request, const Layout& layout, const LayoutGroup& group) {
    std::vector<Vec2> corners;
    for (const std::size_t i : group.items)
        for (const Vec2& p : placed_region(request.items[i].item, layout.placements[i]))
            corners.push_back(p);
    return convex_hull(corners);
}

}  // namespace

TEST_CASE("the items of a folder stand together and nothing of others among them") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const PlanRequest request = nested_request(seed);
        const Layout layout = plan(request);
        CHECK(is_sound(items_of(request), layout, "nested"));
        REQUIRE(layout.groups.size() == 2);
        const GridPolygon first = snapped(hull_of(request, layout, layout.groups[0]));
        const GridPolygon second = snapped(hull_of(request, layout, layout.groups[1]));
        CHECK(UnionArea({first, second}).overlap() == 0);
        for (const Placement& at : layout.placements)
            CHECK(at.scale <= request.max_scale * (1 + 1e-9));
    }
}

TEST_CASE("the cells of a folder lie together, hold their regions, and all cover the canvas once") {
    const PlanRequest request = nested_request(2);
    const Layout layout = plan(request);
    const std::vector<Cell> all = cells(items_of(request), layout);
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Loops parts;
        for (const Polygon& part : all[i].parts)
            parts.push_back(to_grid(part));
        sum += area_of(parts);
        for (const Polygon& part : all[i].filler)
            sum += area(part);
        const Loops region{to_grid(placed_region(request.items[i].item, layout.placements[i]))};
        CHECK(area_of(difference_of(region, parts)) < 1e-3);
    }
    CHECK(sum == doctest::Approx(1920 * 1080).epsilon(1e-5));
}

TEST_CASE("a folder whose shot changes stays where it is") {
    PlanRequest request = nested_request(3);
    const Layout before = plan(request);
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].previous = before.placements[i];
    Random random(9);
    request.items[2] = {.item = random_item(random),
                        .seat = seat_of(request.items[2].item, before.placements[2]),
                        .group = 0};
    const Layout after = plan(request);
    CHECK(is_sound(items_of(request), after, "nested_change"));
    for (const std::size_t i : {4, 5, 6, 7, 8}) {
        const LayoutItem& item = request.items[i].item;
        CHECK(length(seat_of(item, after.placements[i]).centre - seat_of(item, before.placements[i]).centre) <
              0.15 * length(request.canvas));
    }
}

TEST_CASE("without groups a nested plan is a plan") {
    const PlanRequest request = random_request(5, 1);
    CHECK(plan(request).placements == plan_flat(request).placements);
}
