#include "player/layout/edit/wall_way.hpp"

#include "player/layout/cells/grid.hpp"
#include "player/layout/pack/energy.hpp"
#include "tests/player/layout/edit/wished_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A request in which one item is wished elsewhere.
WayRequest request_for(const WallState& wall, std::size_t item) {
    WayRequest request{
        .wall = wall, .wishes = {wish_at(wall, item, wall.canvas * 0.4)}, .keys = 5, .rules = quick_rules};
    for (const LayoutItem& each : wall.items)
        request.pictures.push_back(each.core.max);
    return request;
}

Loops loops_of(const std::vector<Polygon>& outlines) {
    Loops loops;
    for (const Polygon& outline : outlines)
        loops.push_back(to_grid(outline));
    return loops;
}

/// The area of the cells that cover the canvas, px^2.
double covered_area(const WallKey& key) {
    double sum = 0;
    for (std::size_t i = 0; i < key.cells.size(); ++i)
        if (key.alphas[i] >= 1)
            sum += area_of(loops_of(key.cells[i]->parts)) + area_of(loops_of(key.cells[i]->filler));
    return sum;
}

}  // namespace

TEST_CASE("on the way no region is covered, and homes stay") {
    const WayRequest request = request_for(planned_wall(8, 3), 6);
    const WallWay way = way_to(request);
    REQUIRE(way.keys.size() == 5);
    CHECK(way.wayless == 0);
    for (const WallKey& key : way.keys) {
        CHECK(measured(request.wall.items, key.placements).hidden < 1e-6);
        CHECK(key.cells.size() == request.wall.items.size());
        CHECK(std::ranges::count(key.alphas, 1) == 8);
    }
    CHECK(way.homes == request.wall.homes);
}

TEST_CASE(
    "the cells of the others cover the place of a shot in a hand, and leave it its place when it returns") {
    WayRequest request = request_for(planned_wall(8, 3), 6);
    request.lifted = {{6}};
    const double canvas = request.wall.canvas.x * request.wall.canvas.y;
    for (const bool is_let_go : {false, true}) {
        request.wishes[0].is_let_go = is_let_go;
        const WallWay way = way_to(request);
        for (const WallKey& key : way.keys) {
            const bool is_last = &key == &way.keys.back();
            CHECK((key.alphas[6] == 1) == (is_last && is_let_go));
            if (!is_let_go) CHECK(key.alphas[6] == 0);
            CHECK(std::ranges::count(key.alphas, 1) == (is_last && is_let_go ? 8 : 7));
            CHECK(covered_area(key) == doctest::Approx(canvas));
            CHECK(key.cells[6] != nullptr);
        }
    }
}

TEST_CASE("only shots without a free way fade from place to place, over cells that cover all") {
    const double side = 100;
    WayRequest request{.wall = {.canvas = {3 * side, side}}, .keys = 6};
    for (int i = 0; i < 3; ++i) {
        request.wall.items.push_back(
            {.region = to_polygon({{5, 5}, {side - 5, side - 5}}), .core = {{0, 0}, {side, side}}});
        request.wall.placements.push_back({1, {side * i, 0}});
        request.pictures.push_back({side, side});
    }
    request.wall.homes = request.wall.placements;
    std::swap(request.wall.homes[0], request.wall.homes[2]);
    const WallWay way = way_to(request);
    CHECK(way.wayless == 2);
    REQUIRE(way.keys.size() == 6);
    for (const WallKey& key : way.keys) {
        CHECK(key.alphas[1] == 1);
        CHECK(key.placements[1] == request.wall.placements[1]);
        CHECK(covered_area(key) == doctest::Approx(3 * side * side));
        const Loops middle{to_grid(placed_region(request.wall.items[1], key.placements[1]))};
        for (const std::size_t i : {0, 2})
            if (key.alphas[i] > 0)
                CHECK(area_of(intersection_of(middle, loops_of(key.cells[i]->parts))) == 0);
    }
    CHECK(way.keys[0].alphas[0] == doctest::Approx(2.0 / 3));
    CHECK(way.keys[0].placements[0] == request.wall.placements[0]);
    CHECK(way.keys[2].alphas[0] == 0);
    CHECK(way.keys[4].placements[0] == request.wall.homes[0]);
    CHECK(way.keys.back().placements == request.wall.homes);
    CHECK(std::ranges::count(way.keys.back().alphas, 1) == 3);
}

TEST_CASE("a group goes where one of it is wished, all together") {
    PlanRequest planned = random_request(9, 2);
    WayRequest request{.groups = std::vector<LayoutGroup>(3), .keys = 3, .rules = quick_rules};
    for (std::size_t i = 0; i < 9; ++i) {
        planned.items[i].group = static_cast<int>(i / 3);
        request.groups[i / 3].items.push_back(i);
        request.pictures.push_back(planned.items[i].item.core.max);
    }
    request.wall = wall_state(items_of(planned), plan(planned));
    const WallState& wall = request.wall;
    request.wishes = {wish_at(wall, 1, wall.canvas * 0.5)};
    const WallKey end = way_to(request).keys.back();
    CHECK(measured(wall.items, end.placements).hidden < 1e-6);
    CHECK(end.placements != wall.placements);
    for (const LayoutGroup& group : request.groups) {
        const auto growth = [&](std::size_t i) { return end.placements[i].scale / wall.homes[i].scale; };
        const std::size_t first = group.items[0];
        for (const std::size_t i : group.items) {
            CHECK(growth(i) == doctest::Approx(growth(first)));
            const Vec2 apart = wall.homes[i].offset - wall.homes[first].offset;
            CHECK(length(end.placements[i].offset - end.placements[first].offset - apart * growth(i)) < 1e-6);
        }
    }
}
