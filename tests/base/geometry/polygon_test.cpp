#include "base/geometry/polygon.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

TEST_CASE("a box turned into a polygon runs counter-clockwise and keeps its area") {
    const Box box{{1, 2}, {4, 6}};
    CHECK(signed_area(to_polygon(box)) == doctest::Approx(12));
    CHECK(centroid(to_polygon(box)) == Vec2{2.5, 4});
    CHECK(bounding_box(to_polygon(box)) == box);
}

TEST_CASE("the centroid of points without area is their mean") {
    const Polygon line{{0, 0}, {2, 2}, {4, 4}};
    CHECK(centroid(line) == Vec2{2, 2});
}

TEST_CASE("a point on the outline counts as inside") {
    const Polygon square = to_polygon({{0, 0}, {2, 2}});
    CHECK(is_inside_convex(square, {2, 1}));
    CHECK(is_inside_convex(square, {1, 1}));
    CHECK_FALSE(is_inside_convex(square, {2.001, 1}));
    CHECK_FALSE(is_inside_convex({}, {0, 0}));
}

TEST_CASE("clipping a triangle by a box keeps the part inside") {
    const Polygon triangle{{0, 0}, {4, 0}, {0, 4}};
    const Polygon part = clipped(triangle, {{0, 0}, {2, 2}});
    CHECK(area(part) == doctest::Approx(4));
    CHECK(area(clipped(triangle, {{1, 1}, {9, 9}})) == doctest::Approx(2));
    CHECK(clipped(triangle, {{5, 5}, {9, 9}}).empty());
    CHECK(clipped(triangle, {{-1, -1}, {0, 9}}).empty());  // touches only
}
