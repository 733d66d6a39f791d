#include "player/layout/pack/filling.hpp"

#include "player/layout/edit/make_way.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/inversions.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

double background(const PlanRequest& request, const Layout& layout) {
    std::vector<NamedItem> named;
    for (const LayoutItem& item : items_of(request))
        named.push_back({"item", named.size(), item});
    return 1 - plan_result(named, layout).canvas_filled;
}

}  // namespace

TEST_CASE("what no frame reaches is counted") {
    const LayoutItem item{.region = to_polygon({{40, 40}, {60, 60}}), .core = {{0, 0}, {100, 100}}};
    PackingProblem problem;
    problem.shapes = {shape_of(item.region)};
    problem.scales = {1};
    problem.limits = {2};
    problem.pinned = {false};
    problem.field = {{0, 0}, {200, 200}};
    const std::vector<Box> frames{moved(item.core, problem.shapes[0].centroid * -1)};
    CHECK(unfilled_share(problem, frames, {{{50, 50}}, 1}) == doctest::Approx(0.75));
    CHECK(unfilled_share(problem, frames, {{{100, 100}}, 2}) == doctest::Approx(0));
    CHECK(unfilled_share(problem, frames, {{{200, 200}}, 2}) == doctest::Approx(0.75));
}

TEST_CASE(
    "pictures fill a screen that stands upright, where an arrangement of equals leaves much of it empty") {
    double dense = 0;
    for (const std::size_t count : {3, 4, 6})
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            PlanRequest request = random_request(count, seed);
            request.canvas = {1080, 1920};
            request.budget = 150'000;
            const Layout layout = plan(request);
            CHECK(is_sound(items_of(request), layout, "filled"));
            CHECK(background(request, layout) <= 0.03);
        }
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        PlanRequest request = random_request(3, seed);
        request.canvas = {1080, 1920};
        request.budget = 50'000;
        request.fills = false;
        dense = std::max(dense, background(request, plan(request)));
    }
    CHECK(dense > 0.06);
}

TEST_CASE("pictures reach the edge of the screen: no line of a pixel or two stays dark there") {
    constexpr double inset = 0.5;  // px
    constexpr int points = 120;    // a side
    int dark = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        PlanRequest request = random_request(10, seed);
        request.budget = 150'000;
        for (PlanItem& entry : request.items) {  // a region that touches its picture's border
            const Box& core = entry.item.core;
            const double height = core.height();
            entry.item.region = to_polygon({{core.min.x, core.min.y + height * 0.3},
                                            {core.min.x + core.width() * 0.8, core.min.y + height * 0.7}});
        }
        const Layout layout = plan(request);
        const Vec2 inner = request.canvas - Vec2{2 * inset, 2 * inset};
        const auto look_at = [&](double x, double y) {
            const Vec2 point = Vec2{inset, inset} + Vec2{inner.x * x, inner.y * y};
            for (std::size_t i = 0; i < request.items.size(); ++i) {
                const Placement& at = layout.placements[i];
                const Box& core = request.items[i].item.core;
                const Vec2 p = (point - at.offset) * (1 / at.scale);
                if (p.x >= core.min.x && p.x <= core.max.x && p.y >= core.min.y && p.y <= core.max.y) return;
            }
            ++dark;
        };
        for (int k = 0; k < points; ++k) {
            const double share = (k + 0.5) / points;
            look_at(share, 0), look_at(share, 1), look_at(0, share), look_at(1, share);
        }
    }
    CAPTURE(dark);
    CHECK(dark <= 3 * 4 * points * 0.05);
}

TEST_CASE("an item that may not be enlarged stays as large as it may be") {
    PlanRequest request = random_request(5, 2);
    request.max_scale = 1.5;
    request.items.push_back(
        {.item = {.region = to_polygon({{20, 10}, {50, 35}}), .core = {{0, 0}, {60, 40}}}});
    CHECK(plan(request).placements[5].scale > 1.45);
}

TEST_CASE("an order holds while items are resized") {
    PlanRequest request = random_request(7, 3);
    request.order = LayoutOrder::reading;
    const Layout layout = plan(request);
    CHECK(is_sound(items_of(request), layout, "filled_in_order"));
    CHECK(inversions_of(items_of(request), layout) == 0);
}

TEST_CASE("a drag makes those smaller that are in its way, and not all") {
    PlanRequest request = random_request(14, 5);
    const WallState wall = wall_state(items_of(request), plan(request));
    const EditRules rules{.budget = 30'000, .max_scale = 4};
    const Vec2 way = Vec2{960, 540} - seat_of(wall.items[3], wall.homes[3]).centre;
    const Wish wish{.item = 3, .at = {wall.homes[3].scale, wall.homes[3].offset + way}};
    const WallState after = made_way(wall, std::vector{wish}, rules);
    std::size_t as_large = 0;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        if (after.placements[i].scale >= 0.98 * wall.placements[i].scale) ++as_large;
    CHECK(as_large >= 7);
}

TEST_CASE("a wall does not wear out, however many shots follow each other") {
    PlanRequest request = random_request(8, 6);
    WallState wall = wall_state(items_of(request), plan(request));
    Random random(8);
    for (std::uint64_t k = 1; k <= 25; ++k) {
        PlanRequest change{.canvas = wall.canvas, .seed = k, .budget = 40'000, .max_scale = 4};
        for (std::size_t i = 0; i < 8; ++i)
            change.items.push_back({.item = wall.items[i], .previous = wall.placements[i]});
        const std::size_t item = uniform_index(random, 8);
        change.items[item] = {.item = random_item(random),
                              .seat = seat_of(wall.items[item], wall.placements[item])};
        wall = wall_state(items_of(change), plan(change));
    }
    CHECK(is_sound(wall.items, layout_of(wall), "after_many"));
    request.items.clear();
    for (const LayoutItem& item : wall.items)
        request.items.push_back({.item = item});
    CHECK(layout_of(wall).energy <= plan(request).energy + 0.08);
}
