#include "analyzer/saliency/half_planes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

Polygon regular(int corners, Vec2 centre, double radius) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        polygon.push_back(centre + Vec2{std::cos(angle), std::sin(angle)} * radius);
    }
    return polygon;
}

}  // namespace

TEST_CASE("a half-plane cuts a square in half") {
    const Polygon half = cut_by(to_polygon({{0, 0}, {2, 2}}), std::vector<HalfPlane>{{{1, 0}, 1}});
    CHECK(signed_area(half) == doctest::Approx(2));
    CHECK(cut_by(half, std::vector<HalfPlane>{{{1, 0}, -1}}).empty());
}

TEST_CASE("a square widened by one is two longer on each side") {
    CHECK(signed_area(widened(to_polygon({{0, 0}, {2, 2}}), 1)) == doctest::Approx(16));
}

TEST_CASE("simplifying never cuts in and never leaves the box") {
    const Polygon round = regular(40, {50, 50}, 50);
    const Box box{{0, 0}, {100, 100}};
    const Polygon simple = simplified_within(round, 12, box);
    CHECK(simple.size() <= 12);
    CHECK(signed_area(simple) > 0);
    for (const Vec2 p : round)
        CHECK(is_inside_convex(simple, p, 1e-6));
    for (const Vec2 p : simple)
        CHECK(is_inside_convex(to_polygon(box), p, 1e-6));
    CHECK(signed_area(simple) < 1.06 * signed_area(round));
}
