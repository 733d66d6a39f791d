#include "player/layout/pack/contacts.hpp"

#include "player/layout/pack/overlap.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace vitrine;
using namespace vitrine::player;

namespace {

std::vector<Shape> random_shapes(std::size_t count, Random& random) {
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < count; ++i)
        shapes.push_back(shape_of(random_item(random).region));
    return shapes;
}

Vec2 random_vector(Random& random, double max_component) {
    const double x = (2 * uniform(random) - 1) * max_component;
    return {x, (2 * uniform(random) - 1) * max_component};
}

/// The hull of all differences of corners: where b's place relative to a's means an overlap.
Polygon difference(const Shape& a, double scale_a, const Shape& b, double scale_b) {
    Polygon points;
    for (const Vec2 p : a.outline)
        for (const Vec2 q : b.outline)
            points.push_back(p * scale_a - q * scale_b);
    return convex_hull(points);
}

double depth_in(const Polygon& polygon, Vec2 place) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        smallest = std::min(smallest, cross(edge, place - polygon[k]) / length(edge));
    }
    return std::max(0.0, smallest);
}

}  // namespace

TEST_CASE("depth is the distance to the side of the Minkowski difference, either way round") {
    Random random(1);
    const std::vector<Shape> shapes = random_shapes(6, random);
    const std::vector<double> scales{0.1, 0.2, 0.15, 0.1, 0.3, 0.12};
    Contacts contacts(shapes, 0);
    contacts.set_scales(scales);
    for (int round = 0; round < 500; ++round) {
        const std::size_t a = uniform_index(random, 6);
        const std::size_t b = (a + 1 + uniform_index(random, 5)) % 6;
        const Vec2 apart = random_vector(random, 250);
        const double expected = depth_in(difference(shapes[a], scales[a], shapes[b], scales[b]), apart);
        CHECK(std::abs(contacts.depth(a, b, apart) - expected) < Contacts::precision);
        CHECK(contacts.depth(b, a, apart * -1) == contacts.depth(a, b, apart));
        const Vec2 way = contacts.escape(a, b, apart);
        CHECK(contacts.is_clear(a, b, apart + way));
        CHECK(length(way) == doctest::Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("shapes grow until they touch, or reach their limits first") {
    Random random(2);
    const std::vector<Shape> shapes = random_shapes(5, random);
    Contacts contacts(shapes, 1.5);
    int touching = 0;
    for (int round = 0; round < 300; ++round) {
        const std::size_t a = uniform_index(random, 5);
        const std::size_t b = (a + 1 + uniform_index(random, 4)) % 5;
        const Vec2 apart = random_vector(random, 300);
        const GrowingScale first{0.1, 0.05 + 0.2 * uniform(random)};
        const GrowingScale second{0.12, round % 3 == 0 ? 0.2 : 0.05 + 0.2 * uniform(random)};
        const double growth = contacts.max_clear_growth(a, b, apart, {first, second}, 1e9);
        const auto is_clear_at = [&](double g) {
            std::vector<double> scales(5, 1.0);
            scales[a] = std::min(first.rate * g, first.limit);
            scales[b] = std::min(second.rate * g, second.limit);
            contacts.set_scales(scales);
            return contacts.is_clear(a, b, apart);
        };
        if (growth > 1e3) {
            CHECK(is_clear_at(1e9));
            continue;
        }
        if (growth == 0) continue;
        ++touching;
        CHECK(is_clear_at(growth));
        CHECK_FALSE(is_clear_at(growth * 1.001 + 1e-4));
    }
    CHECK(touching > 30);
}

TEST_CASE("shapes that are clear with the least clearance never share a point of the exact grid") {
    Random random(3);
    const std::vector<Shape> shapes = random_shapes(4, random);
    const std::vector<double> scales{0.1, 0.21, 0.15, 0.3};
    Contacts contacts(shapes, 1.0 / 64);
    contacts.set_scales(scales);
    for (int round = 0; round < 2000; ++round) {
        const std::size_t a = uniform_index(random, 4);
        const std::size_t b = (a + 1 + uniform_index(random, 3)) % 4;
        const Vec2 at{900 + 500 * uniform(random), 500 * uniform(random)};
        const Vec2 inside = random_vector(random, 200);
        const Vec2 apart = inside + contacts.escape(a, b, inside);
        if (!contacts.is_clear(a, b, apart)) continue;
        const UnionArea areas({snapped(transformed(shapes[a].outline, scales[a], at)),
                               snapped(transformed(shapes[b].outline, scales[b], at + apart))});
        REQUIRE(areas.overlap() == 0);
    }
}

TEST_CASE("a ray is blocked exactly between its crossings of the Minkowski difference") {
    const std::vector<Shape> shapes{shape_of(to_polygon({{0, 0}, {2, 2}})),
                                    shape_of(to_polygon({{0, 0}, {4, 2}}))};
    Contacts contacts(shapes, 0);
    contacts.set_scales(std::vector<double>{1, 1});
    const RayStretch along =
        contacts.blocked_stretch(0, 1, {-10, 0}, {1, 0});  // the difference is 6 x 4 round 0
    CHECK(along.begin == doctest::Approx(7));
    CHECK(along.end == doctest::Approx(13));
    const RayStretch beside = contacts.blocked_stretch(0, 1, {-10, 2}, {1, 0});
    CHECK_FALSE(beside.begin < beside.end);
    const RayStretch behind = contacts.blocked_stretch(1, 0, {10, 0}, {1, 0});
    CHECK_FALSE(behind.begin < behind.end);
}
