#include "player/layout/cells.hpp"

#include "player/layout/grid.hpp"
#include "player/layout/plan_output.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

namespace {

Loops loops_of(const std::vector<Polygon>& polygons) {
    Loops loops;
    for (const Polygon& polygon : polygons)
        loops.push_back(to_grid(polygon));
    return loops;
}

Loops loops_of(const std::vector<std::array<Vec2, 3>>& triangles) {
    Loops loops;
    for (const auto& t : triangles)
        loops.push_back(to_grid(Polygon(t.begin(), t.end())));
    return loops;
}

/// Cells cover the canvas once, hold their regions, show only what their items have.
void check_cells(const std::vector<LayoutItem>& items, const Layout& layout) {
    const std::vector<Cell> all = cells(items, layout);
    REQUIRE(all.size() == items.size());
    const double canvas_area = layout.canvas.x * layout.canvas.y;
    double sum = 0;
    Loops together;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Cell& cell = all[i];
        const Loops parts = loops_of(cell.parts);
        const Loops filler = loops_of(cell.filler);
        sum += area_of(parts) + area_of(filler);
        together.insert(together.end(), parts.begin(), parts.end());
        together.insert(together.end(), filler.begin(), filler.end());
        CHECK(area_of(loops_of(cell.triangles)) == doctest::Approx(area_of(parts)).epsilon(1e-6));
        CHECK(area_of(loops_of(cell.filler_triangles)) == doctest::Approx(area_of(filler)).epsilon(1e-6));
        const Placement& at = layout.placements[i];
        const Loops region{to_grid(placed_region(items[i], at))};
        REQUIRE_FALSE(cell.parts.empty());
        CHECK(area_of(difference_of(region, {to_grid(cell.parts[0])})) < 1e-3);
        const Loops frame{to_grid(transformed(to_polygon(items[i].core), at.scale, at.offset))};
        CHECK(area_of(difference_of(parts, frame)) < 1e-3);
    }
    CHECK(sum == doctest::Approx(canvas_area).epsilon(1e-6));
    CHECK(area_of(union_of(together, {})) == doctest::Approx(canvas_area).epsilon(1e-6));  // so none overlap
}

}  // namespace

TEST_CASE("cells share the canvas out exactly and hold their regions whole") {
    for (const std::size_t count : {1, 2, 3, 6, 12, 30})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const PlanRequest request = random_request(count, seed);
            check_cells(items_of(request), plan(request));
        }
}

TEST_CASE("small items leave rings of filler that are still covered") {
    const LayoutItem item{.region = to_polygon({{20, 20}, {60, 60}}), .core = {{0, 0}, {80, 80}}};
    const std::vector<LayoutItem> items{item, item};
    const Layout layout{.canvas = {640, 360}, .placements = {{1, {100, 100}}, {1.5, {400, 120}}}};
    check_cells(items, layout);
    const std::vector<Cell> all = cells(items, layout);
    CHECK(area_of(loops_of(all[0].parts)) == doctest::Approx(80 * 80));
    CHECK_FALSE(all[0].filler.empty());
}

TEST_CASE("two equal boxes share the space between them in the middle") {
    const LayoutItem item{.region = to_polygon({{40, 40}, {60, 60}}), .core = {{-500, -500}, {500, 500}}};
    const std::vector<LayoutItem> items{item, item};
    const Layout layout{.canvas = {200, 100}, .placements = {{1, {0, 0}}, {1, {100, 0}}}};
    const std::vector<Cell> all = cells(items, layout);
    CHECK(bounding_box(all[0].parts[0]) == Box{{0, 0}, {100, 100}});
    CHECK(bounding_box(all[1].parts[0]) == Box{{100, 0}, {200, 100}});
}

TEST_CASE("what the nearest cannot show goes to the next who can") {
    const LayoutItem left{.region = to_polygon({{40, 40}, {60, 60}}), .core = {{30, 0}, {90, 100}}};
    const LayoutItem right{.region = to_polygon({{140, 40}, {160, 60}}), .core = {{-500, -500}, {500, 500}}};
    const std::vector<LayoutItem> items{left, right};
    const Layout layout{.canvas = {200, 100}, .placements = {{1, {0, 0}}, {1, {0, 0}}}};
    const std::vector<Cell> all = cells(items, layout);
    CHECK(area_of(loops_of(all[0].parts)) == doctest::Approx(60 * 100));
    CHECK(area_of(loops_of(all[1].parts)) == doctest::Approx(140 * 100));
    CHECK(all[1].parts.size() == 2);
    CHECK(bounding_box(all[1].parts[0]).max.x == 200);
    CHECK(all[0].filler.empty());
}

TEST_CASE("a gutter takes half its width from each side and nothing from a region or the canvas' edge") {
    const LayoutItem item{.region = to_polygon({{40, 40}, {60, 60}}), .core = {{-500, -500}, {500, 500}}};
    const std::vector<LayoutItem> items{item, item};
    const Layout layout{.canvas = {200, 100}, .placements = {{1, {0, 0}}, {1, {100, 0}}}};
    const std::vector<Cell> all = cells(items, layout, {.gutter = 10});
    CHECK(bounding_box(all[0].parts[0]).max.x == doctest::Approx(95).epsilon(0.002));
    CHECK(bounding_box(all[0].parts[0]).min.x == 0);
    const std::vector<Cell> wide = cells(items, layout, {.gutter = 150});
    CHECK(area_of(loops_of(wide[0].parts)) >= 400);
}

TEST_CASE("an empty layout has no cells") {
    CHECK(cells({}, {.canvas = {100, 100}}).empty());
}
