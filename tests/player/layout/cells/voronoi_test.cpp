#include "player/layout/cells/voronoi.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/cells/voronoi_circles.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <doctest/doctest.h>

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

using Outline = std::vector<std::pair<std::int32_t, std::int32_t>>;
using Diagram = boost::polygon::voronoi_diagram<double>;

constexpr std::int32_t origin = 1 << 25;  // the same as in the cells
constexpr std::int32_t tile = 1 << 16;

/// Convex outlines, each in a tile of its own: boxes that line up, octagons with common directions, and
/// hulls of anything. Many of their corners lie on common circles.
std::vector<Outline> outlines(Random& random, bool is_regular) {
    std::vector<Outline> all;
    for (std::int32_t column = 0; column < 4; ++column)
        for (std::int32_t row = 0; row < 3; ++row) {
            const auto any = [&](std::size_t below) {
                return static_cast<std::int32_t>(uniform_index(random, below));
            };
            Polygon corners;
            const std::int32_t side = is_regular ? tile / 2 : tile / 4 + any(tile / 2);
            const std::int32_t cut = side / 4;
            for (const auto& [x, y] : Outline{{cut, 0},
                                              {side - cut, 0},
                                              {side, cut},
                                              {side, side - cut},
                                              {side - cut, side},
                                              {cut, side},
                                              {0, side - cut},
                                              {0, cut}}) {
                const bool is_box = (column + row) % 2 == 0;
                const std::int32_t shift = is_regular ? 0 : any(64);
                corners.push_back({1.0 * (is_box ? (x > side / 2 ? side : 0) : x + shift),
                                   1.0 * (is_box ? (y > side / 2 ? side : 0) : y + shift)});
            }
            Outline outline;
            for (const Vec2& p : convex_hull(corners))
                outline.emplace_back(origin + column * tile + static_cast<std::int32_t>(p.x),
                                     origin + row * tile + static_cast<std::int32_t>(p.y));
            all.push_back(outline);
        }
    return all;
}

template <typename Builder>
std::vector<std::pair<double, double>> corners_of(const std::vector<Outline>& outlines) {
    Builder builder;
    for (const Outline& outline : outlines)
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const auto& [x0, y0] = outline[k];
            const auto& [x1, y1] = outline[(k + 1) % outline.size()];
            builder.insert_segment(x0, y0, x1, y1);
        }
    Diagram diagram;
    builder.construct(&diagram);
    std::vector<std::pair<double, double>> corners;
    for (const auto& vertex : diagram.vertices())
        corners.emplace_back(vertex.x(), vertex.y());
    std::sort(corners.begin(), corners.end());
    return corners;
}

}  // namespace

TEST_CASE("circles found with rounding where it is harmless give the diagram of exact numbers") {
    using Exact = boost::polygon::voronoi_builder<std::int32_t>;
    using Checked = boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers, VoronoiPredicates>;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Random random(seed);
        const std::vector<Outline> all = outlines(random, seed % 2 == 0);
        const auto exact = corners_of<Exact>(all);
        const auto checked = corners_of<Checked>(all);
        REQUIRE(exact.size() == checked.size());
        double farthest = 0;  // largest distance of a corner from the nearest exact one, grid units
        for (const auto& [x, y] : checked) {
            double nearest = 1e9;
            for (const auto& [u, v] : exact)
                nearest = std::min(nearest, std::max(std::abs(x - u), std::abs(y - v)));
            farthest = std::max(farthest, nearest);
        }
        CHECK(farthest < 1e-4);
    }
}

TEST_CASE("a circle that its sites hardly determine is not trusted") {
    CircleCheck sound(0, 0, 5);
    sound.add_point(5, 0);
    sound.add_line(-9, -5, 9, -5);
    sound.add_foot(-3, 4, 1, 7);
    CHECK(sound.holds(1e-12));
    CircleCheck missed(0, 0, 5);
    missed.add_point(5.001, 0);
    missed.add_line(-9, -5, 9, -5);
    missed.add_point(-3, 4);
    CHECK_FALSE(missed.holds(1e-3));
    CHECK(missed.holds(1e-1));
    CircleCheck loose(0, 0, 5);  // two of the three say the same
    loose.add_point(5, 0);
    loose.add_point(5 + 1e-9, 0);
    loose.add_line(-9, -5, 9, -5);
    CHECK_FALSE(loose.holds(1e-3));
    CircleCheck nowhere(std::numeric_limits<double>::quiet_NaN(), 0, 5);
    nowhere.add_point(5, 0);
    nowhere.add_point(0, 5);
    nowhere.add_point(-5, 0);
    CHECK_FALSE(nowhere.holds(1e9));
}
