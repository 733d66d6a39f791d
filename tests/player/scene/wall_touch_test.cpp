#include "player/scene/wall_touch.hpp"

#include "player/scene/wall_cells.hpp"
#include "tests/player/scene/packed_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Kind = Gesture::Kind;

constexpr Vec2 beside_all{-50, -50};

/// A wall that visitors touch.
struct TouchedHouse {
    std::vector<PlacedShot> wall = packed_wall(6);
    WallTouch touch{{.budget = 20'000}, 10s};

    void handle(const Gesture& gesture) { touch.handle_gesture(gesture, wall, packed_canvas); }

    void handle(Kind kind, Vec2 at) { handle({.kind = kind, .at = at, .from = at}); }

    /// Takes the next change of the wall. None: nothing moves.
    std::optional<TouchedWall> move_on(std::chrono::nanoseconds now) {
        std::optional<TouchedWall> next = touch.next_wall(wall, packed_canvas, now);
        if (!next) return next;
        wall = next->wall;
        give_cells(wall, packed_canvas, {});
        return next;
    }

    std::vector<Placement> placements() const {
        std::vector<Placement> all;
        for (const PlacedShot& placed : wall)
            all.push_back(placed.placement);
        return all;
    }
};

}  // namespace

TEST_CASE("a tap enlarges a shot, and a second tap returns all shots to their places") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.handle(Kind::tap, centre_of(house.wall[2]));
    CHECK(house.touch.is_active());
    const std::optional<TouchedWall> larger = house.move_on(0s);
    REQUIRE(larger);
    CHECK_FALSE(larger->pace);
    CHECK(house.wall[2].placement.scale > 1.2 * before[2].scale);
    CHECK_FALSE(house.move_on(1s));

    house.handle(Kind::tap, centre_of(house.wall[2]));
    CHECK(house.move_on(2s));
    CHECK(house.placements() == before);
    CHECK_FALSE(house.touch.is_active());
}

TEST_CASE("a tapped shot returns after its time; a held one when the finger is lifted") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.handle(Kind::tap, centre_of(house.wall[1]));
    REQUIRE(house.move_on(5s));
    CHECK_FALSE(house.move_on(14999ms));
    CHECK(house.move_on(15s));
    CHECK(house.placements() == before);

    house.handle(Kind::hold, centre_of(house.wall[1]));
    REQUIRE(house.move_on(20s));
    CHECK_FALSE(house.move_on(500s));
    house.handle(Kind::release, centre_of(house.wall[1]));
    CHECK(house.move_on(501s));
    CHECK(house.placements() == before);
}

TEST_CASE("a tap beside all shots, a key, or another change of the wall ends the enlargement") {
    for (const int way : {0, 1, 2}) {
        CAPTURE(way);
        TouchedHouse house;
        const std::vector<Placement> before = house.placements();
        house.handle(Kind::tap, centre_of(house.wall[0]));
        REQUIRE(house.move_on(0s));
        if (way == 0) house.handle(Kind::tap, beside_all);
        if (way == 1) house.handle({.kind = Kind::key, .key = Key::back});
        if (way == 2) house.touch.end_enlargement();
        CHECK(house.move_on(1s));
        CHECK(house.placements() == before);
    }
}

TEST_CASE("a drag first returns a large shot to its place, then moves a shot in short steps") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    house.handle(Kind::tap, centre_of(house.wall[0]));
    REQUIRE(house.move_on(0s));
    const Vec2 from = centre_of(house.wall[3]);
    house.handle({.kind = Kind::drag, .at = packed_canvas * 0.5, .from = from});
    const std::optional<TouchedWall> back = house.move_on(1s);
    REQUIRE(back);
    CHECK_FALSE(back->pace);
    CHECK(house.placements() == before);

    const Vec2 start = centre_of(house.wall[3]);
    const Vec2 to{packed_canvas.x - start.x, packed_canvas.y - start.y};
    house.handle(Kind::drop, to);
    house.handle({.kind = Kind::drag, .at = to, .from = start});
    const std::optional<TouchedWall> step = house.move_on(2s);
    REQUIRE(step);
    REQUIRE(step->pace);
    CHECK(*step->pace < 500ms);
    CHECK(house.wall[3].placement != before[3]);
    CHECK(house.touch.is_active());

    house.handle(Kind::drop, to);
    for (auto now = 3s; now < 10s && house.touch.is_active(); now += 1s)
        house.move_on(now);
    CHECK_FALSE(house.touch.is_active());
}

TEST_CASE("a flick beyond the edge dismisses a shot: the others stay, and its seat is free") {
    TouchedHouse house;
    const std::vector<Placement> before = house.placements();
    const Vec2 at = centre_of(house.wall[4]);
    house.handle({.kind = Kind::flick, .at = at, .from = at, .velocity = {-10'000, 0}});
    CHECK(house.touch.is_active());
    const std::optional<DismissedShot> dismissed = house.touch.take_dismissed(house.wall);
    REQUIRE(dismissed);
    CHECK(dismissed->source == 5);
    CHECK(dismissed->slot == 4);
    CHECK(length(dismissed->seat.centre - at) < 1e-9);
    CHECK(dismissed->seat.area > 0);
    REQUIRE(dismissed->rest.wall.size() == 5);
    for (const PlacedShot& placed : dismissed->rest.wall)
        CHECK(placed.placement == before[placed.shot.source - 1]);
    CHECK(dismissed->rest.pace);
    CHECK_FALSE(house.touch.take_dismissed(house.wall));
    CHECK_FALSE(house.touch.is_active());
}

TEST_CASE("a flick that ends on the canvas, or begins beside all shots, dismisses none") {
    TouchedHouse house;
    const Vec2 at = packed_canvas * 0.5;
    house.handle({.kind = Kind::flick, .at = at, .from = at, .velocity = {200, -100}});
    CHECK_FALSE(house.touch.take_dismissed(house.wall));
    house.handle({.kind = Kind::flick, .at = at, .from = beside_all, .velocity = {10'000, 0}});
    CHECK_FALSE(house.touch.take_dismissed(house.wall));
    CHECK_FALSE(house.touch.is_active());
}

TEST_CASE("a shot that was dragged and then flicked away leaves the seat from which it was dragged") {
    TouchedHouse house;
    const Vec2 home = centre_of(house.wall[0]);
    const Vec2 to{packed_canvas.x - home.x, packed_canvas.y - home.y};
    for (auto now = 0s; now < 4s; now += 1s) {
        house.handle({.kind = Kind::drag, .at = to, .from = home});
        house.move_on(now);
    }
    REQUIRE(length(centre_of(house.wall[0]) - home) > 20);
    // no shot is where the finger came down any more, or another one
    house.handle({.kind = Kind::flick, .at = to, .from = home, .velocity = {0, 10'000}});
    const std::optional<DismissedShot> dismissed = house.touch.take_dismissed(house.wall);
    REQUIRE(dismissed);
    CHECK(dismissed->source == 1);
    CHECK(length(dismissed->seat.centre - home) < 1e-9);
}

TEST_CASE("a flicked shot that has left the wall meanwhile is not dismissed again") {
    TouchedHouse house;
    const Vec2 at = centre_of(house.wall[5]);
    house.handle({.kind = Kind::flick, .at = at, .from = at, .velocity = {0, 10'000}});
    house.wall.pop_back();
    CHECK_FALSE(house.touch.take_dismissed(house.wall));
    CHECK_FALSE(house.touch.is_active());
}
