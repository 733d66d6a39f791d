#include "player/layout/cells/taut.hpp"

#include "player/layout/cells/cells.hpp"
#include "player/layout/cells/seam_bends.hpp"
#include "tests/player/layout/cells/shown_frame.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const CellStyle taut{.is_taut = true};

struct Wall {
    std::vector<LayoutItem> items;
    Layout layout;
};

Wall random_wall(std::size_t count, std::uint64_t seed) {
    const PlanRequest request = random_request(count, seed);
    return {items_of(request), plan(request)};
}

Loops grid_loops(const std::vector<Polygon>& polygons) {
    Loops loops;
    for (const Polygon& polygon : polygons)
        loops.push_back(to_grid(polygon));
    return loops;
}

/// The cells' parts, then their fillers.
std::vector<Loops> areas_on(const Wall& wall, const CellStyle& style) {
    const std::vector<Cell> made = cells(wall.items, wall.layout, style);
    std::vector<Loops> areas;
    for (const Cell& cell : made)
        areas.push_back(grid_loops(cell.parts));
    for (const Cell& cell : made)
        areas.push_back(grid_loops(cell.filler));
    return areas;
}

/// The number of bends of each seam between two items.
std::vector<std::size_t> bends_on(const Wall& wall, const CellStyle& style) {
    const auto seams = seams_of(areas_on(wall, style), {{0, 0}, wall.layout.canvas});
    REQUIRE(seams);
    std::vector<std::size_t> bends;
    for (const Seam& seam : *seams)
        if (seam.right < wall.items.size()) bends.push_back(bends_of(seam));
    return bends;
}

/// Every place belongs to one cell, which holds its whole region and shows only what its item has.
void check_partition(const Wall& wall, const CellStyle& style) {
    const std::vector<Loops> areas = areas_on(wall, style);
    const Box canvas{{0, 0}, wall.layout.canvas};
    double sum = 0;
    Loops all;
    for (const Loops& loops : areas) {
        sum += area_of(loops);
        all.insert(all.end(), loops.begin(), loops.end());
    }
    CHECK(sum == doctest::Approx(canvas.area()).epsilon(1e-12));
    CHECK(area_of(union_of(all, {})) == doctest::Approx(canvas.area()).epsilon(1e-12));
    for (std::size_t i = 0; i < wall.items.size(); ++i) {
        const Placement& at = wall.layout.placements[i];
        const Polygon region = clipped(placed_region(wall.items[i], at), canvas);
        CHECK(area_of(difference_of({to_grid(region)}, areas[i])) < 1e-4);
        const Loop core = to_grid(to_polygon(shown_frame(wall.items[i], at, wall.layout.canvas)));
        CHECK(area_of(difference_of(areas[i], {core})) < 1e-3);
    }
}

/// A canvas of 300 x 100 px in three areas, with a crooked seam between the left two.
std::vector<Loops> three_areas() {
    const std::vector<Polygon> areas{{{0, 0}, {100, 0}, {130, 40}, {90, 70}, {100, 100}, {0, 100}},
                                     {{100, 0}, {200, 0}, {200, 100}, {100, 100}, {90, 70}, {130, 40}},
                                     {{200, 0}, {300, 0}, {300, 100}, {200, 100}}};
    std::vector<Loops> loops;
    for (const Polygon& area : areas)
        loops.push_back({to_grid(area)});
    return loops;
}

const Box small_canvas{{0, 0}, {300, 100}};

/// All items have pixels everywhere.
SeamLimits limits_of(const std::vector<Polygon>& regions) {
    SeamLimits limits;
    for (const Polygon& region : regions) {
        limits.regions.push_back(to_grid(region));
        limits.cores.push_back({to_grid(to_polygon(small_canvas))});
    }
    return limits;
}

const Seam& seam_between(const std::vector<Seam>& seams, std::size_t left, std::size_t right) {
    const auto found = std::ranges::find_if(
        seams, [&](const Seam& seam) { return seam.left == left && seam.right == right; });
    REQUIRE(found != seams.end());
    return *found;
}

}  // namespace

TEST_CASE("areas are taken apart into seams and put together again") {
    const auto seams = seams_of(three_areas(), small_canvas);
    REQUIRE(seams);
    CHECK(bends_of(seam_between(*seams, 0, 1)) == 2);
    CHECK(bends_of(seam_between(*seams, 1, 2)) == 0);
    const std::vector<Loops> again = areas_of(*seams, 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(area_of(again[i]) == area_of(three_areas()[i]));
}

TEST_CASE("areas with a gap or an overlap have no seams") {
    std::vector<Loops> gap = three_areas();
    gap[2] = {to_grid(Polygon{{210, 0}, {300, 0}, {300, 100}, {210, 100}})};
    CHECK_FALSE(seams_of(gap, small_canvas));
    std::vector<Loops> overlap = three_areas();
    overlap[2] = {to_grid(Polygon{{190, 0}, {300, 0}, {300, 100}, {190, 100}})};
    CHECK_FALSE(seams_of(overlap, small_canvas));
}

TEST_CASE("a seam with nothing in its way becomes straight") {
    auto seams = seams_of(three_areas(), small_canvas);
    REQUIRE(seams);
    pull_taut(*seams, limits_of({{}, {}, {}}));
    CHECK(bends_of(seam_between(*seams, 0, 1)) == 0);
}

TEST_CASE("a taut seam bends at the region that is in its way, on the same side as before") {
    auto seams = seams_of(three_areas(), small_canvas);
    REQUIRE(seams);
    const Polygon region{{20, 20}, {112, 20}, {112, 50}, {20, 50}};
    pull_taut(*seams, limits_of({region, {}, {}}));
    const Seam& seam = seam_between(*seams, 0, 1);
    CHECK(bends_of(seam) == 2);
    CHECK(std::ranges::find(seam.line, to_grid({112, 20})) != seam.line.end());
    CHECK(std::ranges::find(seam.line, to_grid({112, 50})) != seam.line.end());
}

TEST_CASE("a round bend is longer and cuts no region") {
    auto seams = seams_of(three_areas(), small_canvas);
    REQUIRE(seams);
    const SeamLimits limits = limits_of({{{20, 30}, {120, 40}, {20, 50}}, {}, {}});
    const std::size_t before = seam_between(*seams, 0, 1).line.size();
    round_bends(*seams, limits, 30);
    CHECK(seam_between(*seams, 0, 1).line.size() > before + 2);
    const std::vector<Loops> areas = areas_of(*seams, 3);
    CHECK(area_of(difference_of({limits.regions[0]}, areas[0])) == 0);
    CHECK(area_of(areas[0]) + area_of(areas[1]) + area_of(areas[2]) == 300 * 100);
}

TEST_CASE("taut cells share the canvas out exactly and hold their regions whole") {
    for (const std::size_t count : {2, 3, 5, 8, 12, 20})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            CAPTURE(count);
            CAPTURE(seed);
            const Wall wall = random_wall(count, seed);
            check_partition(wall, taut);
            check_partition(wall, {.is_taut = true, .corner_radius = 24});
        }
}

TEST_CASE("taut seams have at most three bends in the median and eight at worst") {
    std::vector<std::size_t> bends;
    for (const std::size_t count : {2, 3, 5, 8, 12, 20})
        for (std::uint64_t seed = 1; seed <= 4; ++seed)
            for (const std::size_t some : bends_on(random_wall(count, seed), taut))
                bends.push_back(some);
    std::ranges::sort(bends);
    CHECK(bends[bends.size() / 2] <= 3);
    CHECK(bends.back() <= 8);
}

TEST_CASE("small items keep their filler when seams are taut") {
    const LayoutItem item{.region = to_polygon({{20, 20}, {60, 60}}), .core = {{0, 0}, {80, 80}}};
    const Wall wall{{item, item}, {.canvas = {640, 360}, .placements = {{1, {100, 100}}, {1.5, {400, 120}}}}};
    check_partition(wall, taut);
    CHECK(area_of(areas_on(wall, taut)[0]) == doctest::Approx(80 * 80));
}

TEST_CASE("groups keep their items together when seams are taut") {
    Wall wall = random_wall(9, 2);
    PlanRequest request = random_request(9, 2);
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].group = static_cast<int>(i / 3);
    wall.layout = plan(request);
    check_partition(wall, taut);
}

TEST_CASE("a gutter between taut cells is as wide as asked for beside a region that a seam bends round") {
    const LayoutItem left{.region = to_polygon({{20, 40}, {96, 60}}), .core = {{-500, -500}, {500, 500}}};
    const LayoutItem right{.region = to_polygon({{150, 10}, {180, 90}}), .core = {{-500, -500}, {500, 500}}};
    const std::vector<LayoutItem> items{left, right};
    const Layout layout{.canvas = {200, 100}, .placements = {{1, {0, 0}}, {1, {0, 0}}}};
    const std::vector<Cell> made = cells(items, layout, {.is_taut = true, .gutter = 10});
    const Loops mine = grid_loops(made[0].parts);
    const Loops others = grid_loops(made[1].parts);
    CHECK(area_of(intersection_of(grown(mine, 9.8), others)) == 0);
    CHECK(area_of(intersection_of(grown(mine, 10.5), others)) > 0);
}
