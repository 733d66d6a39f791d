#include "player/layout/edit/edit.hpp"

#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

WallState random_wall(std::size_t count, std::uint64_t seed) {
    PlanRequest request = random_request(count, seed);
    request.budget = 10'000;
    request.fills = false;
    return wall_state(items_of(request), plan(request));
}

bool is_sound(const WallState& wall, const std::string& name) {
    return wall.placements.size() == wall.items.size() && wall.homes.size() == wall.items.size() &&
           wall.pinned.size() == wall.items.size() && is_sound(wall.items, layout_of(wall), name);
}

Vec2 place(const WallState& wall, std::size_t item) {
    return seat_of(wall.items[item], wall.placements[item]).centre;
}

/// The place nearest to the finger at which the item lies inside the canvas.
Vec2 moved_inside(const WallState& wall, std::size_t item, Vec2 finger) {
    const Box box = moved(bounding_box(placed_region(wall.items[item], wall.placements[item])),
                          finger - place(wall, item));
    return {finger.x + std::max(0.0, -box.min.x) - std::max(0.0, box.max.x - wall.canvas.x),
            finger.y + std::max(0.0, -box.min.y) - std::max(0.0, box.max.y - wall.canvas.y)};
}

double median_move(const WallState& before, const WallState& after, std::size_t but) {
    std::vector<double> moves;
    for (std::size_t i = 0; i < std::min(before.items.size(), after.items.size()); ++i)
        if (i != but) moves.push_back(length(place(after, i) - place(before, i)));
    std::sort(moves.begin(), moves.end());
    return moves[moves.size() / 2] / length(after.canvas);
}

const EditRules quick{.budget = 20'000, .max_scale = 4};

}  // namespace

TEST_CASE("a newcomer finds a place and the others hardly move") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const WallState wall = random_wall(12, seed);
        Random random(seed);
        const WallState after = inserted(wall, random_item(random), quick);
        CHECK(is_sound(after, "inserted"));
        CHECK(after.items.size() == 13);
        CHECK(median_move(wall, after, 12) <= 0.1);
        const WallState there = inserted(wall, random_item(random), {.max_scale = 4}, Vec2{300, 300});
        CHECK(is_sound(there, "inserted_there"));
        CHECK(length(place(there, 12) - Vec2{300, 300}) < 250);
    }
}

TEST_CASE("the others grow into the room of an item that leaves") {
    const WallState wall = random_wall(12, 2);
    const WallState after = deleted(wall, 5, quick);
    CHECK(is_sound(after, "deleted"));
    CHECK(after.items.size() == 11);
    CHECK(after.items[5] == wall.items[6]);
    CHECK(after.placements[0].scale >= 0.999 * wall.placements[0].scale);
    WallState last = random_wall(1, 1);
    CHECK(deleted(last, 0, quick).items.empty());
}

TEST_CASE("a slot's next shot stands where the last one stood, in its size") {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const WallState wall = random_wall(12, seed);
        Random random(seed + 50);
        const WallState after = replaced(wall, 4, random_item(random), quick);
        CHECK(is_sound(after, "replaced"));
        CHECK(median_move(wall, after, 4) <= 0.1);
        CHECK(length(place(after, 4) - place(wall, 4)) < 0.15 * length(wall.canvas));
    }
}

TEST_CASE("a dragged item follows the finger, the others make way and go back, and nothing is ever covered") {
    const WallState wall = random_wall(9, 3);
    const Vec2 from = place(wall, 0);
    const Vec2 to{1920 - from.x, 1080 - from.y};
    WallState now = wall;
    for (int k = 1; k <= 12; ++k) {
        const Vec2 finger = from + (to - from) * (k / 12.0);
        now = dragged(now, 0, finger, quick);
        REQUIRE(is_sound(now, "dragged"));
        CHECK(length(place(now, 0) - moved_inside(wall, 0, finger)) < 60);
    }
    for (int k = 11; k >= 0; --k) {
        now = dragged(now, 0, from + (to - from) * (k / 12.0), quick);
        REQUIRE(is_sound(now, "dragged_back"));
    }
    CHECK(median_move(wall, now, 0) < 0.03);
    const WallState dropped = settled(now, quick);
    CHECK(is_sound(dropped, "dropped"));
    CHECK(dropped.homes == dropped.placements);
}

TEST_CASE("no edit moves a pinned item but its own") {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        WallState wall = random_wall(10, seed);
        wall.pinned[1] = wall.pinned[6] = true;
        Random random(seed);
        for (const WallState& after :
             {inserted(wall, random_item(random), quick), replaced(wall, 3, random_item(random), quick),
              dragged(wall, 0, {900, 500}, quick), resized(wall, 4, 1.5, quick), settled(wall, quick)}) {
            CHECK(is_sound(after, "pinned"));
            CHECK(after.placements[1] == wall.placements[1]);
            CHECK(after.placements[6] == wall.placements[6]);
            CHECK(after.pinned[6]);
        }
        const WallState pushed = dragged(wall, 0, place(wall, 1), quick);  // stops at the pinned one
        CHECK(is_sound(pushed, "pushed"));
        CHECK(pushed.placements[1] == wall.placements[1]);
    }
}

TEST_CASE("a newcomer among pinned items becomes small enough for what is free") {
    WallState wall = random_wall(8, 5);
    wall.pinned.assign(8, true);
    Random random(5);
    const LayoutItem newcomer = random_item(random);
    const WallState after = inserted(wall, newcomer, quick);
    CHECK(is_sound(after, "small"));
    for (std::size_t i = 0; i < 8; ++i)
        CHECK(after.placements[i] == wall.placements[i]);
}

TEST_CASE("a resized item has its new size") {
    const WallState wall = random_wall(8, 4);
    const WallState smaller = resized(wall, 2, 0.6, quick);
    CHECK(is_sound(smaller, "smaller"));
    CHECK(smaller.placements[2].scale == doctest::Approx(0.6 * wall.placements[2].scale));
    const WallState larger = resized(smaller, 2, 1.4, quick);
    CHECK(is_sound(larger, "larger"));
    CHECK(larger.placements[2].scale > smaller.placements[2].scale);
}

TEST_CASE("on a large wall only the neighbours of an edit move") {
    const WallState wall = random_wall(80, 7);
    Random random(7);
    const WallState after = replaced(wall, 10, random_item(random), quick);
    CHECK(is_sound(after, "large"));
    long moved = 0;
    for (std::size_t i = 0; i < 80; ++i)
        moved += i != 10 && after.placements[i] != wall.placements[i] ? 1 : 0;
    CHECK(moved < 30);
    CHECK(is_sound(inserted(wall, random_item(random), quick), "large_inserted"));
    CHECK(is_sound(deleted(wall, 33, quick), "large_deleted"));
}

TEST_CASE("the same edit of the same wall gives the same") {
    const WallState wall = random_wall(7, 8);
    Random random(8);
    const LayoutItem newcomer = random_item(random);
    CHECK(inserted(wall, newcomer, quick).placements == inserted(wall, newcomer, quick).placements);
}

TEST_CASE("hundreds of random edits in a row never cover a region") {
    Random random(21);
    WallState wall = random_wall(5, 21);
    EditRules rules{.budget = 2'000, .max_scale = 4};
    for (int k = 0; k < 250; ++k) {
        rules.seed = static_cast<std::uint64_t>(k);
        const std::size_t item = wall.items.empty() ? 0 : uniform_index(random, wall.items.size());
        const double x = uniform(random);
        const Vec2 to{x * wall.canvas.x, uniform(random) * wall.canvas.y};
        switch (wall.items.size() < 2 ? 0 : uniform_index(random, 7)) {
        case 0:
            wall = wall.items.size() < 10 ? inserted(wall, random_item(random), rules)
                                          : deleted(wall, item, rules);
            break;
        case 1:
            wall = deleted(wall, item, rules);
            break;
        case 2:
            wall = replaced(wall, item, random_item(random), rules);
            break;
        case 3:
            wall = resized(wall, item, 0.6 + uniform(random), rules);
            break;
        case 4:
            wall.pinned[item] = !wall.pinned[item];
            break;
        case 5:
            wall = settled(wall, rules);
            break;
        default:
            wall = dragged(wall, item, to, rules);
        }
        REQUIRE(is_sound(wall, "edited"));
    }
}
