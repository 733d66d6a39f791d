#include "player/layout/pack/shape.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A region of a share of the frame's sides, in its middle.
LayoutItem item_of(Vec2 frame, double share, double weight = 1) {
    const Vec2 half = frame * (share / 2);
    return {.region = to_polygon({frame * 0.5 - half, frame * 0.5 + half}),
            .core = {{0, 0}, frame},
            .weight = weight};
}

std::vector<double> areas_of(const std::vector<LayoutItem>& items) {
    std::vector<Shape> shapes;
    for (const LayoutItem& item : items)
        shapes.push_back(shape_of(item.region));
    const std::vector<double> scales = natural_scales(items, shapes);
    std::vector<double> areas;
    for (std::size_t i = 0; i < items.size(); ++i)
        areas.push_back(shapes[i].area * scales[i] * scales[i]);
    return areas;
}

}  // namespace

TEST_CASE("a large picture weighs no more than a small one of the same subject") {
    const std::vector<double> areas = areas_of({item_of({4000, 3000}, 0.6), item_of({400, 300}, 0.6)});
    CHECK(areas[0] == doctest::Approx(areas[1]));
}

TEST_CASE("twice the weight is twice the area, within the bounds") {
    const Vec2 frame{800, 600};
    const std::vector<double> areas = areas_of(
        {item_of(frame, 0.6), item_of(frame, 0.6, 1.8), item_of(frame, 0.6), item_of(frame, 0.6, 0.6)});
    CHECK(areas[1] / areas[0] == doctest::Approx(1.8));
    CHECK(areas[3] / areas[0] == doctest::Approx(0.6));
}

TEST_CASE("no region is larger than twice the median or smaller than half of it") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        std::vector<LayoutItem> items;
        for (int i = 0; i < 9; ++i)
            items.push_back(item_of({500, 400}, 0.2 + 0.8 * uniform(random), 0.25 + 4 * uniform(random)));
        std::vector<double> areas = areas_of(items);
        std::sort(areas.begin(), areas.end());
        CHECK(areas.front() >= areas[4] / 2 * (1 - 1e-9));
        CHECK(areas.back() <= areas[4] * 2 * (1 + 1e-9));
    }
}

TEST_CASE("no item is enlarged beyond what the request allows, however small it is") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        PlanRequest request = random_request(5, seed);
        request.max_scale = 1.5;
        request.items.push_back({.item = item_of({60, 40}, 0.7, 4)});
        request.items.push_back({.item = item_of({300, 200}, 0.7)});
        const Layout layout = plan(request);
        for (const Placement& placement : layout.placements)
            CHECK(placement.scale <= 1.5);
        CHECK(layout.placements[5].scale > 1.4);
    }
}

TEST_CASE("a region without area becomes the thinnest box round it") {
    CHECK(shape_of({}).area == doctest::Approx(1));
    CHECK(shape_of(Polygon{{3, 4}}).area == doctest::Approx(1));
    CHECK(shape_of(Polygon{{0, 0}, {10, 0}, {20, 0}}).area == doctest::Approx(20));
}
