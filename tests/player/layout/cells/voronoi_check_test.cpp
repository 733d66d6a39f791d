#include "player/layout/cells/voronoi_check.hpp"

#include "player/layout/cells/voronoi.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const Box canvas{{0, 0}, {640, 360}};

/// Walls on which two I-Regions are nearer to each other than a step of the grid of sites: fingers had moved
/// them so.
std::vector<std::vector<Polygon>> walls_that_touch() {
    const std::vector<std::vector<Box>> boxes{
        {{{1.5958910314351442, 92.378100483045017}, {109.32893969872379, 184.72071362643527}},
         {{233.98950765559155, 203.25422079476658}, {400.61993930388769, 328.22704453098868}},
         {{313.29874560466624, 116.29445483318187}, {382.20983593830255, 185.20554516681818}},
         {{66.089905652201367, 184.72312347616145}, {228.43969639857983, 323.88008697305725}},
         {{419.4184782510697, 39.65106904011455}, {587.13190794651393, 165.43614131169778}},
         {{465.89750374357658, 198.38373421232657}, {624.57905875642336, 357.06528922517344}},
         {{7.8552449650873086, 5.0151811007786904}, {106.26552908198784, 89.366853200979151}}},
        {{{142.259544506596, 184.45893083197518}, {218.125834789919, 260.32522111529818}},
         {{216.32866538256107, 10.417800244886422}, {416.08024928269424, 181.63344358785773}},
         {{220.88139396171192, 186.55944481439479}, {449.16891841900696, 357.7750881573661}},
         {{519.79662274443115, 129.94814293753797}, {630.46381099903124, 240.615331192138}},
         {{0.010044642857167219, 188.64225041393436}, {125.67558477152016, 296.35557052421689}},
         {{470.61035565311801, 0.76481667090817496}, {639.28564084409754, 127.27128056414284}},
         {{500.53284274693385, 240.61552904655906}, {619.90168870037473, 359.984375}},
         {{4.867865654863067, 0.015625}, {204.61944955499627, 171.2312683429713}}}};
    std::vector<std::vector<Polygon>> walls;
    for (const std::vector<Box>& wall : boxes) {
        walls.emplace_back();
        for (const Box& box : wall)
            walls.back().push_back(to_polygon(box));
    }
    return walls;
}

/// The part of the regions that is in other cells than their own, px^2.
double misplaced(const std::vector<Polygon>& regions, const std::vector<Loops>& cells) {
    double sum = 0;
    for (std::size_t i = 0; i < regions.size(); ++i)
        sum += area(regions[i]) - area_of(intersection_of({to_grid(regions[i])}, cells[i]));
    return sum;
}

}  // namespace

TEST_CASE("regions that nearly touch have cells that hold them") {
    for (const std::vector<Polygon>& regions : walls_that_touch()) {
        const std::vector<Loops> cells = voronoi(regions, canvas);
        CHECK(are_nearest(cells, regions, canvas));
        CHECK(misplaced(regions, cells) < 5);  // along some hundred px
    }
}

TEST_CASE("regions that touch along a whole side have cells that hold them") {
    for (const double gap : {0.0, 1.0 / 1024, 1.0 / 300, 1.0 / 128}) {
        const std::vector<Polygon> regions{to_polygon({{100.3, 50}, {200, 150.7}}),
                                           to_polygon({{200 + gap, 50}, {310, 150.7}}),
                                           to_polygon({{150, 150.7 + gap}, {260, 240}})};
        const std::vector<Loops> cells = voronoi(regions, canvas);
        CHECK(are_nearest(cells, regions, canvas));
        CHECK(misplaced(regions, cells) < 10);
    }
}

TEST_CASE("cells that are exchanged, missing or too small are wrong") {
    const std::vector<Polygon> regions{to_polygon({{50, 50}, {150, 150}}),
                                       to_polygon({{300, 60}, {420, 170}}),
                                       to_polygon({{200, 220}, {330, 330}})};
    const std::vector<Loops> good = voronoi(regions, canvas);
    REQUIRE(are_nearest(good, regions, canvas));
    std::vector<Loops> cells = good;
    std::swap(cells[0], cells[1]);
    CHECK_FALSE(are_nearest(cells, regions, canvas));
    cells = good;
    cells[2].clear();
    CHECK_FALSE(are_nearest(cells, regions, canvas));
    cells = good;
    cells[0].front().front() = to_grid(Vec2{310, 100});
    CHECK_FALSE(are_nearest(cells, regions, canvas));
}
