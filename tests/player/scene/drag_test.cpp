#include "player/scene/drag.hpp"

#include "player/layout/pack/energy.hpp"
#include "tests/player/scene/packed_wall.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr Vec2 canvas = packed_canvas;

double share_seen(const std::vector<PlacedShot>& wall) {
    double sum = 0;
    for (const PlacedShot& placed : wall)
        sum += seat_of(placed.shot.item, placed.placement).area;
    return sum / (canvas.x * canvas.y);
}

/// One step; true where something moved. Checks what must hold after every one.
bool step(Drag& drag, std::vector<PlacedShot>& wall) {
    const auto placements = drag.next_placements(wall, canvas);
    if (!placements) return false;
    REQUIRE(placements->size() == wall.size());
    std::vector<LayoutItem> items;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        wall[i].placement = (*placements)[i];
        items.push_back(wall[i].shot.item);
    }
    const Measure measure = measured(items, *placements);
    REQUIRE(measure.hidden == 0);
    REQUIRE(measure.bounds.min.x >= 0);
    REQUIRE(measure.bounds.min.y >= 0);
    REQUIRE(measure.bounds.max.x <= canvas.x);
    REQUIRE(measure.bounds.max.y <= canvas.y);
    give_cells(wall, canvas, {});
    return true;
}

void touch(Drag& drag, Vec2 at) {
    drag.follow_finger(at, at);
}

}  // namespace

TEST_CASE("what is held follows the finger across the wall, and settles at its size where it is dropped") {
    std::vector<PlacedShot> wall = packed_wall(8);
    const double seen = share_seen(wall);
    const double scale = wall[0].placement.scale;
    const Vec2 from = centre_of(wall[0]);
    const Vec2 to{canvas.x - from.x, canvas.y - from.y};
    Drag drag({.budget = 20'000});
    for (int k = 0; k <= 12; ++k) {
        drag.follow_finger(from + (to - from) * (k / 12.0), from);
        step(drag, wall);
        CHECK(share_seen(wall) > 0.5 * seen);
    }
    for (int k = 0; k < 4; ++k)
        step(drag, wall);
    CHECK(length(centre_of(wall[0]) - to) < 0.1 * length(canvas));
    CHECK(wall[0].placement.scale < 0.9 * scale);
    drag.lift_finger();
    CHECK(drag.held());
    CHECK(step(drag, wall));
    CHECK_FALSE(drag.held());
    CHECK(wall[0].placement.scale > 0.8 * scale);
    CHECK(length(centre_of(wall[0]) - to) < 0.2 * length(canvas));
    CHECK(share_seen(wall) > 0.8 * seen);
    CHECK_FALSE(drag.next_placements(wall, canvas));
}

TEST_CASE("a finger that goes anywhere never makes regions overlap or leave the canvas") {
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> share(-0.2, 1.2);
    for (const int count : {1, 2, 7}) {
        std::vector<PlacedShot> wall = packed_wall(count);
        Drag drag({.budget = 10'000});
        for (int k = 0; k < 40; ++k) {
            if (k % 9 == 8)
                drag.lift_finger();
            else
                touch(drag, {share(engine) * canvas.x, share(engine) * canvas.y});
            step(drag, wall);
        }
    }
}

TEST_CASE("a finger that rests moves nothing, and none at all neither") {
    std::vector<PlacedShot> wall = packed_wall(5);
    Drag drag({});
    CHECK_FALSE(drag.next_placements(wall, canvas));
    touch(drag, centre_of(wall[2]));
    CHECK_FALSE(drag.next_placements(wall, canvas));
    CHECK(drag.held());
    Drag empty({});
    touch(empty, {10, 10});
    CHECK_FALSE(empty.next_placements({}, canvas));
}

TEST_CASE("a shot that leaves the wall leaves the hand") {
    std::vector<PlacedShot> wall = packed_wall(5);
    Drag drag({.budget = 10'000});
    touch(drag, centre_of(wall[4]));
    drag.next_placements(wall, canvas);
    REQUIRE(drag.held());
    wall.pop_back();
    step(drag, wall);
    CHECK_FALSE(drag.held());
}
