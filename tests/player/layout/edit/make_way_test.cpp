#include "player/layout/edit/make_way.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

WallState random_wall(std::size_t count, std::uint64_t seed) {
    const PlanRequest request = random_request(count, seed);
    return wall_state(items_of(request), plan(request));
}

Vec2 place_of(const WallState& wall, std::size_t item, const Placement& at) {
    return seat_of(wall.items[item], at).centre;
}

/// The item at its home, moved so that its centroid is at a place, at three quarters of its size.
Wish wish_at(const WallState& wall, std::size_t item, Vec2 place) {
    const Placement& home = wall.homes[item];
    const Vec2 middle = place_of(wall, item, home);
    return {.item = item, .at = {home.scale * 0.75, place - (middle - home.offset) * 0.75}};
}

const EditRules rules{.budget = 20'000, .max_scale = 4};

}  // namespace

TEST_CASE("the others make way locally: none goes farther than a quarter of the diagonal, most stay") {
    std::vector<double> ways;
    Random random(5);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const WallState wall = random_wall(12, seed);
        for (int k = 0; k < 8; ++k) {
            const std::size_t held = uniform_index(random, wall.items.size());
            Wish wish =
                wish_at(wall, held, {wall.canvas.x * uniform(random), wall.canvas.y * uniform(random)});
            wish.is_let_go = k % 2 == 0;
            const WallState next = made_way(wall, std::vector{wish}, rules);
            CHECK(measured(next.items, next.placements).hidden == 0);
            for (std::size_t i = 0; i < wall.items.size(); ++i)
                if (i != held)
                    ways.push_back(
                        length(place_of(wall, i, next.placements[i]) - place_of(wall, i, wall.homes[i])) /
                        length(wall.canvas));
        }
    }
    std::ranges::sort(ways);
    CHECK(ways.back() <= 0.25);
    CHECK(ways[ways.size() / 2] <= 0.05);
}

TEST_CASE(
    "without wishes all are at home exactly; a wish leaves the homes, one that was let go changes them") {
    WallState wall = random_wall(8, 4);
    wall.placements[2].offset.x += 40;
    CHECK(made_way(wall, {}, rules).placements == wall.homes);
    Wish wish = wish_at(wall, 1, wall.canvas * 0.5);
    CHECK(made_way(wall, std::vector{wish}, rules).homes == wall.homes);
    wish.is_let_go = true;
    const WallState after = made_way(wall, std::vector{wish}, rules);
    CHECK(after.homes == after.placements);
    CHECK(after.homes != wall.homes);
}

TEST_CASE("ten wishes at once are given room together, and two on one another are not both heard") {
    const WallState wall = random_wall(12, 6);
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < 10; ++i)
        wishes.push_back(wish_at(wall, i, {100.0 + 190 * static_cast<double>(i % 5), i < 5 ? 300.0 : 700.0}));
    wishes[3].at = wish_at(wall, 3, place_of(wall, 2, wishes[2].at)).at;
    const WallState next = made_way(wall, wishes, rules);
    CHECK(measured(next.items, next.placements).hidden == 0);
}

TEST_CASE("on the way no region is covered, and homes stay") {
    const WallState wall = random_wall(8, 3);
    WayRequest request{
        .wall = wall, .wishes = {wish_at(wall, 6, wall.canvas * 0.4)}, .keys = 5, .rules = rules};
    for (const LayoutItem& item : wall.items)
        request.pictures.push_back(item.core.max);
    const WallWay way = way_to(request);
    REQUIRE(way.keys.size() == (way.is_free ? 5 : 1));
    for (const WallKey& key : way.keys) {
        CHECK(measured(wall.items, key.placements).hidden < 1e-6);
        CHECK(key.cells.size() == wall.items.size());
    }
    CHECK(way.homes == wall.homes);
}

TEST_CASE("a group goes where one of it is wished, all together") {
    PlanRequest planned = random_request(9, 2);
    WayRequest request{.groups = std::vector<LayoutGroup>(3), .keys = 3, .rules = rules};
    for (std::size_t i = 0; i < 9; ++i) {
        planned.items[i].group = static_cast<int>(i / 3);
        request.groups[i / 3].items.push_back(i);
        request.pictures.push_back(planned.items[i].item.core.max);
    }
    request.wall = wall_state(items_of(planned), plan(planned));
    const WallState& wall = request.wall;
    request.wishes = {wish_at(wall, 1, wall.canvas * 0.5)};
    const WallKey end = way_to(request).keys.back();
    CHECK(measured(wall.items, end.placements).hidden < 1e-6);
    CHECK(end.placements != wall.placements);
    for (const LayoutGroup& group : request.groups) {
        const auto growth = [&](std::size_t i) { return end.placements[i].scale / wall.homes[i].scale; };
        const std::size_t first = group.items[0];
        for (const std::size_t i : group.items) {
            CHECK(growth(i) == doctest::Approx(growth(first)));
            const Vec2 apart = wall.homes[i].offset - wall.homes[first].offset;
            CHECK(length(end.placements[i].offset - end.placements[first].offset - apart * growth(i)) < 1e-6);
        }
    }
}
