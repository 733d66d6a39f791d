#include "player/layout/plan/motion.hpp"

#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <array>
#include <map>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const LayoutItem square{.region = to_polygon({{-10, -10}, {10, 10}}), .core = {{-20, -20}, {20, 20}}};

/// Boxes and triangles of all sizes thrown onto a canvas; those that find no free place become smaller.
std::vector<Placement> thrown(const std::vector<LayoutItem>& items, Vec2 canvas, Random& random) {
    std::vector<Placement> placements;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Box box = bounding_box(items[i].region);
        double scale = 0.4 * std::min(canvas.x / box.width(), canvas.y / box.height());
        for (bool is_free = false; !is_free; scale *= 0.95) {
            const Vec2 room = canvas - (box.max - box.min) * scale;
            const double x = uniform(random);
            const Vec2 corner{x * room.x, uniform(random) * room.y};
            const Placement at{scale, corner - box.min * scale};
            is_free = true;
            for (std::size_t j = 0; j < i && is_free; ++j)
                is_free = overlap_interval({items[i], at, at}, {items[j], placements[j], placements[j]}, 0.1)
                              .is_empty();
            if (is_free) placements.push_back(at);
        }
    }
    return placements;
}

/// Checks the exact areas at random times; the search itself only knows intervals.
void check_motion(const std::vector<LayoutItem>& items, const Motion& motion, Vec2 canvas, Random& random,
                  int times) {
    for (int k = 0; k < times; ++k) {
        const Layout now{.canvas = canvas, .placements = placements_at(motion, uniform(random))};
        REQUIRE(is_sound(items, now, "on_the_way"));
    }
}

}  // namespace

TEST_CASE("two squares on a collision course overlap from touch to touch") {
    // 20 wide, the gap of 60 closes at 200 px a unit of time, and opens behind after another 40 px.
    const OverlapInterval overlap =
        overlap_interval({square, {1, {0, 0}}, {1, {200, 0}}}, {square, {1, {80, 0}}, {1, {80, 0}}}, 0);
    CHECK(overlap.begin == doctest::Approx(60.0 / 200));
    CHECK(overlap.end == doctest::Approx(100.0 / 200));
}

TEST_CASE("squares that slide along each other do not overlap") {
    const OverlapInterval overlap =
        overlap_interval({square, {1, {0, 0}}, {1, {200, 0}}}, {square, {1, {80, 20}}, {1, {80, 20}}}, 0);
    CHECK(overlap.is_empty());
}

TEST_CASE("a square that grows overlaps from the moment it reaches the other") {
    // Its right side runs from 10 to 50, the other's left side stands at 30.
    const OverlapInterval overlap =
        overlap_interval({square, {1, {0, 0}}, {5, {0, 0}}}, {square, {1, {40, 0}}, {1, {40, 0}}}, 0);
    CHECK(overlap.begin == doctest::Approx(0.5));
    CHECK(overlap.end == 1);
}

TEST_CASE("what does not move stands still, and what is free moves straight") {
    const std::vector<LayoutItem> items{square, square};
    const std::vector<Placement> from{{1, {20, 20}}, {1, {60, 20}}};
    CHECK(motion_between(items, from, from, {200, 100})->kind == Motion::Kind::still);
    const std::vector<Placement> to{{1, {20, 60}}, {1.5, {80, 20}}};
    const auto motion = motion_between(items, from, to, {200, 100});
    REQUIRE(motion);
    CHECK(motion->kind == Motion::Kind::straight);
    CHECK(placements_at(*motion, 0) == from);
    CHECK(placements_at(*motion, 1) == to);
    CHECK(placements_at(*motion, 0.5)[0] == Placement{1, {20, 40}});
}

TEST_CASE("what goes where another stands waits for it") {
    const std::vector<LayoutItem> items{square, square};
    const std::vector<Placement> from{{1, {20, 20}}, {1, {60, 20}}};
    const std::vector<Placement> to{{1, {60, 20}},
                                    {1, {60, 50}}};  // the second leaves slower than the first comes
    const auto motion = motion_between(items, from, to, {200, 100});
    REQUIRE(motion);
    CHECK(motion->kind == Motion::Kind::staged);
    CHECK(motion->keys.size() == 3);
    CHECK(motion->keys[1][0] == from[0]);
    CHECK(motion->keys[1][1] == to[1]);
}

TEST_CASE("items that change places go around each other rather than become small") {
    const std::vector<LayoutItem> items{square, square};
    const auto exchanged = [&](double y, Vec2 canvas) {
        const std::vector<Placement> places{{2, {40, y}}, {2, {120, y}}};
        return motion_between(items, places, std::vector{places[1], places[0]}, canvas);
    };
    Random random(1);
    for (const double y : {40, 50}) {
        const auto motion = exchanged(y, {160, 100});
        REQUIRE(motion);
        CHECK(motion->kind == Motion::Kind::detour);
        CHECK(smallest_scale(*motion) >= 0.9);
        check_motion(items, *motion, {160, 100}, random, 200);
    }
    CHECK_FALSE(exchanged(40, {160, 60}));  // one had to be half as large
}

TEST_CASE("a seat is guarded in its middle where its two shots have a quarter of it in common") {
    const Polygon common = to_polygon({{100, 50}, {110, 60}});  // 100 px^2
    const auto guard = guard_of_seat(common, 390);
    REQUIRE(guard);
    const Box box = bounding_box(guard->region);
    CHECK(length(box.min - Vec2{103.5, 53.5}) < 1e-9);
    CHECK(length(box.max - Vec2{106.5, 56.5}) < 1e-9);
    CHECK_FALSE(guard_of_seat(common, 410));
    CHECK_FALSE(guard_of_seat({}, 410));
}

TEST_CASE("where there is no way there is no motion") {
    // Each fills the canvas' height, and half of it, when small: two cannot pass a third.
    const LayoutItem wall{.region = to_polygon({{-10, -50}, {10, 50}}), .core = {{-10, -50}, {10, 50}}};
    const std::vector<LayoutItem> items{wall, wall, wall};
    const std::vector<Placement> from{{1, {20, 50}}, {1, {60, 50}}, {1, {100, 50}}};
    const std::vector<Placement> to{{1, {100, 50}}, {1, {20, 50}}, {1, {60, 50}}};
    CHECK_FALSE(motion_between(items, from, to, {120, 100}));
}

TEST_CASE("no region is ever covered between thousands of random layouts") {
    constexpr Vec2 canvas{1600, 900};
    Random random(11);
    std::map<Motion::Kind, int> kinds;
    int none = 0;
    for (int k = 0; k < 2500; ++k) {
        std::vector<LayoutItem> items;
        const std::size_t count = 2 + uniform_index(random, 7);
        for (std::size_t i = 0; i < count; ++i)
            items.push_back(random_item(random));
        const std::vector<Placement> from = thrown(items, canvas, random);
        std::vector<Placement> to = k % 2 == 0 ? thrown(items, canvas, random) : from;
        if (k % 2 == 1) {  // some change, the others stand
            const std::vector<Placement> other = thrown(items, canvas, random);
            for (std::size_t i = 0; i < count; i += 2) {
                std::vector<Placement> trial = to;
                trial[i] = other[i];
                if (measured(items, trial).hidden == 0) to = trial;
            }
        }
        const auto motion = motion_between(items, from, to, canvas);
        if (!motion) {
            ++none;
            continue;
        }
        ++kinds[motion->kind];
        REQUIRE(placements_at(*motion, 0) == from);
        REQUIRE(placements_at(*motion, 1) == to);
        REQUIRE(smallest_scale(*motion) >= min_scale_on_way);
        check_motion(items, *motion, canvas, random, 12);
    }
    CHECK(kinds[Motion::Kind::straight] > 200);
    CHECK(kinds[Motion::Kind::staged] > 20);
    CHECK(kinds[Motion::Kind::shrunk] > 20);
    CHECK(kinds[Motion::Kind::detour] > 100);
    CHECK(none < 1000);
}
