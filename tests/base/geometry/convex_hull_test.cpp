#include "base/geometry/convex_hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace vitrine;

TEST_CASE("the hull is the same whatever the order of points that share an x") {
    Polygon points{{0, 0}, {0, 3}, {0, 1}, {2, 0}, {2, 3}, {2, 2}, {1, 1}, {0, 3}};
    const Polygon expected{{0, 0}, {2, 0}, {2, 3}, {0, 3}};
    std::mt19937 random(7);
    for (int i = 0; i < 50; ++i) {
        std::shuffle(points.begin(), points.end(), random);
        CHECK(convex_hull(points) == expected);
    }
}

TEST_CASE("degenerate points give fewer than three corners") {
    CHECK(convex_hull({}).empty());
    CHECK(convex_hull(Polygon{{1, 1}, {1, 1}}).size() == 1);
    CHECK(convex_hull(Polygon{{0, 0}, {1, 1}, {3, 3}, {2, 2}}) == Polygon{{0, 0}, {3, 3}});
}

TEST_CASE("every point lies inside its hull and every corner is a point") {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> pixel(0, 20);
    for (int round = 0; round < 200; ++round) {
        Polygon points;
        for (int i = 0; i < 30; ++i)
            points.push_back({static_cast<double>(pixel(random)), static_cast<double>(pixel(random))});
        const Polygon hull = convex_hull(points);
        REQUIRE(hull.size() >= 3);
        CHECK(signed_area(hull) > 0);
        for (const Vec2& p : points)
            CHECK(is_inside_convex(hull, p));
        for (const Vec2& p : hull)
            CHECK(std::find(points.begin(), points.end(), p) != points.end());
    }
}
