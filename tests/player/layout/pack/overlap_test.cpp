#include "player/layout/pack/overlap.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/pack/overlap_pieces.hpp"

#include <clipper.hpp>
#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace vitrine;
using namespace vitrine::player;

namespace {

GridPolygon square(double x, double y, double side) {
    return snapped(to_polygon({{x, y}, {x + side, y + side}}));
}

/// The area of the union by another library, px^2.
double clipper_area(const std::vector<GridPolygon>& polygons) {
    constexpr ClipperLib::cInt finer = 65536;
    ClipperLib::Clipper engine;
    for (const GridPolygon& polygon : polygons) {
        ClipperLib::Path path;
        for (const GridPoint& p : polygon)  // a finer grid, as the library rounds crossings to it
            path.emplace_back(ClipperLib::cInt{p.x} * finer, ClipperLib::cInt{p.y} * finer);
        engine.AddPath(path, ClipperLib::ptSubject, true);
    }
    ClipperLib::Paths united;
    engine.Execute(ClipperLib::ctUnion, united, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    double sum = 0;
    for (const ClipperLib::Path& path : united)
        sum += ClipperLib::Area(path);
    return sum / (1.0 * finer * finer * grid_per_px * grid_per_px);
}

GridPolygon random_polygon(std::mt19937& random, int range) {
    std::uniform_int_distribution<int> place(0, range);
    Polygon points;
    for (int i = 0; i < 7; ++i)
        points.push_back({static_cast<double>(place(random)), static_cast<double>(place(random))});
    return snapped(convex_hull(points));
}

}  // namespace

TEST_CASE("two squares that overlap by a quarter count it once") {
    const UnionArea areas({square(0, 0, 2), square(1, 1, 2)});
    CHECK(areas.sum() == 8);
    CHECK(areas.area() == 7);
    CHECK(areas.overlap() == 1);
    CHECK(areas.bounds() == Box{{0, 0}, {3, 3}});
}

TEST_CASE("coincident, touching, nested and collinear squares are counted exactly") {
    CHECK(UnionArea({square(0, 0, 2), square(0, 0, 2), square(0, 0, 2)}).area() == 4);
    CHECK(UnionArea({square(0, 0, 2), square(2, 0, 2)}).overlap() == 0);
    CHECK(UnionArea({square(0, 0, 2), square(2, 1, 2)}).overlap() == 0);
    CHECK(UnionArea({square(0, 0, 2), square(2, 2, 2)}).overlap() == 0);
    CHECK(UnionArea({square(0, 0, 4), square(1, 1, 2)}).overlap() == 4);
    CHECK(UnionArea({square(0, 0, 4), square(0, 1, 2)}).overlap() == 4);
    CHECK(UnionArea({square(0, 0, 2), square(1, 0, 2), square(2, 0, 2)}).area() == 8);
    CHECK(UnionArea({square(0, 0, 2), {}}).area() == 4);
    CHECK(UnionArea({}).area() == 0);
}

namespace {

/// Shapes made to meet: parts of one box, moved by whole, half and no sides, scaled about corners, cut along
/// diagonals.
std::vector<GridPolygon> meeting_polygons(std::mt19937& random) {
    const auto any = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    const Polygon shapes[] = {to_polygon({{0, 0}, {4, 4}}),
                              {{0, 0}, {4, 0}, {0, 4}},
                              {{0, 0}, {4, 4}, {0, 4}},
                              {{2, 0}, {4, 2}, {2, 4}, {0, 2}},
                              {{0, 0}, {8, 0}, {6, 2}, {2, 2}}};
    std::vector<GridPolygon> polygons;
    const int count = 2 + any(7);
    for (int i = 0; i < count; ++i) {
        const double scale = any(3) == 0 ? 0.5 : 1;
        const Vec2 at{20 + 2.0 * any(4), 20 + 2.0 * any(4)};
        polygons.push_back(snapped(transformed(shapes[any(5)], scale, at)));
        if (any(4) == 0) polygons.push_back(polygons[random() % polygons.size()]);
    }
    return polygons;
}

}  // namespace

TEST_CASE("coincident, touching, nested and collinear polygons agree with another library and another way") {
    std::mt19937 random(17);
    for (int round = 0; round < 400; ++round) {
        const std::vector<GridPolygon> polygons = meeting_polygons(random);
        const UnionArea areas(polygons);
        REQUIRE(areas.area() == doctest::Approx(clipper_area(polygons)).epsilon(1e-6));
        std::vector<Polygon> px;
        for (const GridPolygon& polygon : polygons)
            px.push_back(to_px(polygon));
        REQUIRE(areas.area() == doctest::Approx(union_area_by_pieces(px)).epsilon(1e-12));
        std::vector<GridPolygon> reversed(polygons.rbegin(), polygons.rend());
        REQUIRE(UnionArea(reversed).area() == doctest::Approx(areas.area()).epsilon(1e-14));
    }
}

TEST_CASE("polygons that only touch overlap by exactly nothing, one step nearer by more") {
    std::mt19937 random(23);
    for (int round = 0; round < 500; ++round) {
        const GridPolygon one = random_polygon(random, 100);
        if (one.empty()) continue;
        const std::size_t edge = random() % one.size();
        const GridPoint a = one[edge];
        const GridPoint b = one[(edge + 1) % one.size()];
        GridPolygon
            other;  // the point reflection of `one` about the middle of an edge, doubled to stay whole
        for (const GridPoint& p : one)
            other.push_back({a.x + b.x - p.x, a.y + b.y - p.y});
        UnionArea areas({one, other});
        REQUIRE(areas.overlap() == 0);
        const GridPoint inward{b.y - a.y > 0 ? -1 : (b.y - a.y < 0 ? 1 : 0),
                               b.x - a.x > 0 ? 1 : (b.x - a.x < 0 ? -1 : 0)};
        areas.move(1, inward);
        REQUIRE(areas.overlap() > 0);
        areas.move(1, {-inward.x, -inward.y});
        REQUIRE(areas.overlap() == 0);
    }
}

TEST_CASE("the union's area is that of another library") {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        std::vector<GridPolygon> polygons;
        for (int i = 0; i < 8; ++i)  // on few integers, so that many corners and edges coincide
            polygons.push_back(random_polygon(random, round % 2 == 0 ? 6 : 1000));
        const UnionArea areas(polygons);
        CHECK(areas.area() == doctest::Approx(clipper_area(polygons)).epsilon(1e-6));
        CHECK(areas.overlap() >= -1e-12 * areas.sum());
    }
}

TEST_CASE("areas kept by moves equal fresh ones to the last bit") {
    std::mt19937 random(5);
    std::vector<GridPolygon> polygons;
    for (int i = 0; i < 12; ++i)
        polygons.push_back(random_polygon(random, 300));
    UnionArea kept(polygons);
    std::uniform_int_distribution<int> step(-100 * 256, 100 * 256);
    for (int move = 0; move < 400; ++move) {
        const std::size_t i = random() % polygons.size();
        const GridPoint by{step(random) / 4, step(random) / 4};
        const GridPoint corner = kept.polygon(i)[0];
        if (std::abs(corner.x + by.x) > 500 * 256 || std::abs(corner.y + by.y) > 500 * 256) continue;
        kept.move(i, by);
        for (GridPoint& p : polygons[i])
            p = {p.x + by.x, p.y + by.y};
        const UnionArea fresh(polygons);
        REQUIRE(kept.area() == fresh.area());
        REQUIRE(kept.overlap() == fresh.overlap());
        REQUIRE(kept.bounds() == fresh.bounds());
    }
}

TEST_CASE("rounding to the grid leaves a convex polygon or nothing") {
    CHECK(snapped(Polygon{{0, 0}, {1e-4, 0}, {0, 1e-4}}).empty());
    CHECK(snapped(Polygon{{0, 0}, {1, 1}, {2, 2}}).empty());
    const GridPolygon triangle = snapped(Polygon{{0.001, 0}, {2, 0}, {1, 1.9999}});
    CHECK(triangle == GridPolygon{{0, 0}, {512, 0}, {256, 512}});
}
