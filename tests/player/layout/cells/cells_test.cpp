#include "player/layout/cells/cells.hpp"

#include "player/layout/cells/grid.hpp"
#include "player/layout/cells/triangulation.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/cells/shown_frame.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

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
        const Loops frame{to_grid(to_polygon(shown_frame(items[i], at, layout.canvas)))};
        CHECK(area_of(difference_of(parts, frame)) < 1e-3);
    }
    CHECK(sum == doctest::Approx(canvas_area).epsilon(1e-6));
    CHECK(area_of(union_of(together, {})) == doctest::Approx(canvas_area).epsilon(1e-6));  // so none overlap
}

}  // namespace

TEST_CASE("an outline that crosses itself by a step of the grid is triangulated whole") {
    const Loop outline{{10142179, 3916434}, {10104576, 4047538}, {10054036, 4649608}, {10013212, 5924864},
                       {10011986, 6220461}, {10166321, 6328505}, {10166322, 6328505}, {6974856, 5385043},
                       {10335278, 3402489}, {10335277, 3402489}, {10217694, 3655464}};
    std::int64_t whole = 0;
    for (std::size_t k = 1; k + 1 < outline.size(); ++k)
        whole += turn(outline[0], outline[k], outline[k + 1]);
    std::int64_t sum = 0;
    for (const GridTriangle& t : triangulated(outline))
        sum += turn(t[0], t[1], t[2]);
    CHECK(static_cast<double>(sum) == doctest::Approx(static_cast<double>(whole)).epsilon(1e-4));
}

// Each was a cell in a frame of a change, of which a triangle lay over a neighbour's I-Region.
TEST_CASE("an outline with a needle is triangulated whole, and nothing beside it") {
    const std::vector<Polygon> outlines{{{353.2730712890625, 159.06573486328125},
                                         {326.02395629882812, 159.06573486328125},
                                         {330.17691040039062, 162.10867309570312},
                                         {327.30767822265625, 166.87890625},
                                         {326.85922241210938, 167.63946533203125},
                                         {313.8150634765625, 190.21371459960938},
                                         {313.8150634765625, 269.9837646484375},
                                         {445.32449340820312, 269.9837646484375},
                                         {445.32449340820312, 269.98379516601562},
                                         {313.8150634765625, 269.9837646484375},
                                         {311.20611572265625, 269.98379516601562},
                                         {192.50888061523438, 269.98379516601562},
                                         {195.96206665039062, 246.66796875},
                                         {197.25015258789062, 163.28921508789062},
                                         {214.91513061523438, 133.06881713867188},
                                         {274.16110229492188, 133.06881713867188},
                                         {274.16110229492188, 136.88809204101562},
                                         {445.32449340820312, 136.88809204101562},
                                         {445.32449340820312, 159.06573486328125}},
                                        {{479.984375, 269.984375},
                                         {280.52218627929688, 269.98434448242188},
                                         {280.52215576171875, 269.984375},
                                         {249.1505126953125, 269.984375},
                                         {249.1505126953125, 269.98434448242188},
                                         {280.52215576171875, 269.984375},
                                         {280.52218627929688, 269.98434448242188},
                                         {285.69021606445312, 263.10714721679688},
                                         {285.69021606445312, 242.43814086914062},
                                         {285.69021606445312, 144.351318359375},
                                         {285.69021606445312, 125.71322631835938},
                                         {297.5048828125, 125.71322631835938},
                                         {366.00845336914062, 125.71322631835938},
                                         {479.984375, 125.71322631835938}}};
    for (const Polygon& polygon : outlines) {
        Loop outline = to_grid(polygon);
        for (std::size_t begin = 0; begin < outline.size(); ++begin) {
            CAPTURE(begin);
            double sum = 0;
            for (const GridTriangle& t : triangulated(outline)) {
                CHECK(turn(t[0], t[1], t[2]) >= 0);
                sum += static_cast<double>(turn(t[0], t[1], t[2]));
            }
            CHECK(sum == doctest::Approx(std::abs(twice_area(outline))).epsilon(1e-6));
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
        }
    }
}

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

namespace {

/// The length of the border of two areas, px.
double touch_of(const Loops& one, const Loops& other) {
    return area_of(intersection_of(grown(one, 0.5), other)) / 0.5;
}

}  // namespace

TEST_CASE("a cell is one piece, but for what no neighbour has pixels for") {
    int apart = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        PlanRequest request = random_request(9, seed);
        request.budget = 2'000;
        request.fills = false;
        const std::vector<LayoutItem> items = items_of(request);
        const Layout layout = plan(request);
        const std::vector<Cell> all = cells(items, layout);
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t k = 1; k < all[i].parts.size(); ++k) {
                const Loops far{to_grid(all[i].parts[k])};
                if (touch_of(far, {to_grid(all[i].parts[0])}) > 1) continue;  // joined, it would have a hole
                for (std::size_t j = 0; j < all.size(); ++j) {
                    const Placement& at = layout.placements[j];
                    const Loops core{to_grid(transformed(to_polygon(items[j].core), at.scale, at.offset))};
                    if (j != i && touch_of(far, loops_of(all[j].parts)) > 1)
                        CHECK(area_of(intersection_of(far, core)) < 0.1 * area_of(far));
                }
                ++apart;
            }
    }
    CHECK(apart <= 16);
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

TEST_CASE("sampled sites ripple and erode as far as their spacing says, exact ones never") {
    // Two walls 8 px apart, sampled inside by 2 px: the ripple is s^2 / (8 (g + 2 d)), so regions are cut
    // from a spacing of 2 sqrt(g (g + 2 d)) = 19.6 px on.
    const LayoutItem wall{.region = to_polygon({{0, 0}, {96, 400}}), .core = {{-500, -500}, {500, 900}}};
    LayoutItem lower = wall;  // its samples lie at other heights
    lower.region = to_polygon({{0, 30}, {96, 400}});
    const std::vector<LayoutItem> items{wall, lower};
    const Layout layout{.canvas = {200, 400}, .placements = {{1, {0, 0}}, {1, {104, 0}}}};
    const auto lost = [&](double spacing) {
        const std::vector<Cell> all = cells(items, layout, {.sample_spacing = spacing, .sample_inset = 2});
        double sum = 0;
        for (std::size_t i = 0; i < 2; ++i)
            sum += area_of(difference_of({to_grid(placed_region(items[i], layout.placements[i]))},
                                         loops_of(all[i].parts)));
        return sum;
    };
    CHECK(lost(0) == 0);
    CHECK(lost(15) < 0.5);
    CHECK(lost(60) > lost(15) + 1);
}

TEST_CASE("rounded corners never cut a region and only take from the cells") {
    const PlanRequest request = random_request(6, 3);
    const std::vector<LayoutItem> items = items_of(request);
    const Layout layout = plan(request);
    const std::vector<Cell> sharp = cells(items, layout, {.gutter = 6});
    const std::vector<Cell> round = cells(items, layout, {.gutter = 6, .corner_radius = 25});
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Loops region{to_grid(placed_region(items[i], layout.placements[i]))};
        CHECK(area_of(difference_of(region, loops_of(round[i].parts))) < 1e-3);
        CHECK(area_of(difference_of(loops_of(round[i].parts), loops_of(sharp[i].parts))) < 0.05);
        CHECK(area_of(loops_of(round[i].parts)) < area_of(loops_of(sharp[i].parts)));
    }
}

TEST_CASE("feathers end before the next region and before the picture does") {
    const LayoutItem item{.region = to_polygon({{40, 40}, {60, 60}}), .core = {{-500, -500}, {500, 500}}};
    const LayoutItem near{.region = to_polygon({{-24, 40}, {60, 60}}), .core = {{-500, -500}, {500, 500}}};
    const std::vector<LayoutItem> items{item, near};
    const Layout layout{.canvas = {200, 100}, .placements = {{1, {0, 0}}, {1, {100, 0}}}};
    const std::vector<Cell> all = cells(items, layout, {.feather = 30});
    REQUIRE_FALSE(all[0].fade_edges.empty());
    double widest = 0;
    for (const FadeEdge& edge : all[0].fade_edges)
        for (std::size_t k = 0; k < edge.outline.size(); ++k) {
            const Vec2 p = edge.outline[k];
            widest = std::max(widest, edge.widths[k]);
            if (std::abs(p.y - 50) < 8 && p.x > 60) CHECK(p.x + edge.widths[k] <= 76 + 1e-9);
        }
    CHECK(widest > 8);
    CHECK(cells(items, layout)[0].fade_edges.empty());
}

TEST_CASE("a cell sends no needle along the canvas' edge, where other pictures end a hair before it") {
    const Vec2 canvas{1000, 400};
    std::vector<LayoutItem> items;
    Layout layout{.canvas = canvas};
    for (const double left : {0.0, 400.0, 700.0}) {
        const double end = left == 400 ? 500 : 399.98;
        items.push_back({.region = {{left, 100}, {left + 200, 100}, {left + 200, 390}, {left, 390}},
                         .core = {{-100, -100}, {1100, end}}});
        layout.placements.push_back({});
    }
    check_cells(items, layout);
    CHECK(bounding_box(cells(items, layout)[1].parts[0]).width() < 500);
}

TEST_CASE("a narrow strip between two pictures goes to the items along it, not to one of them alone") {
    const Box film{{0, 0}, {1000, 160}};
    const std::vector<LayoutItem> items{
        {.region = to_polygon(film), .core = film},
        {.region = to_polygon({{0, 162}, {510, 380}}), .core = {{-100, -100}, {1100, 500}}},
        {.region = to_polygon({{530, 162}, {1000, 380}}), .core = {{400, -100}, {1100, 500}}}};
    const Layout layout{.canvas = {1000, 400}, .placements = {{}, {}, {}}};
    check_cells(items, layout);
    CHECK(bounding_box(cells(items, layout)[2].parts[0]).min.x > 515);
}
