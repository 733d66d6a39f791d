#include "player/layout/edit/make_way.hpp"

#include "player/layout/edit/edit_window.hpp"
#include "player/layout/pack/energy.hpp"
#include "tests/player/layout/edit/wished_wall.hpp"
#include "tests/player/layout/real_items.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// The share of the canvas that no picture reaches, on a grid of points.
double open_share(const WallState& wall) {
    constexpr int samples = 64;
    int open = 0;
    for (int k = 0; k < samples * samples; ++k) {
        const Vec2 point{(k % samples + 0.5) / samples * wall.canvas.x,
                         (k / samples + 0.5) / samples * wall.canvas.y};
        bool is_seen = false;
        for (std::size_t i = 0; i < wall.items.size(); ++i)
            is_seen =
                is_seen || is_box_within({point, point}, placed_core(wall.items[i], wall.placements[i]));
        open += is_seen ? 0 : 1;
    }
    return static_cast<double>(open) / (samples * samples);
}

struct Drops {
    std::size_t items = 0;  // of a wall
    std::uint64_t walls = 0;
};

/// The shares of the canvas that no picture reaches after each of five drops on some walls, in order.
std::vector<double> open_after_drops(const Drops& drops) {
    std::vector<double> open;
    Random random(1);
    for (std::uint64_t k = 0; k < drops.walls; ++k) {
        PlanRequest request = random_request(drops.items, k + 1);
        request.canvas = {640, 360};
        request.budget = 300'000;
        for (std::size_t i = 0; i < request.items.size(); ++i)
            request.items[i].item = real_items()[(i + k) % real_items().size()];
        WallState wall = wall_state(items_of(request), plan(request));
        for (int drop = 0; drop < 5; ++drop) {
            const std::size_t held = uniform_index(random, wall.items.size());
            Wish wish = wish_at(wall, held, {640 * uniform(random), 360 * uniform(random)});
            wish.is_let_go = true;
            wall = made_way(wall, std::vector{wish}, {.seed = k, .max_scale = 4});
            open.push_back(open_share(wall));
        }
    }
    std::ranges::sort(open);
    return open;
}

}  // namespace

TEST_CASE("after a drop on a small wall pictures cover the canvas, also after many drops") {
    const std::vector<double> open = open_after_drops({.items = 8, .walls = 3});
    CHECK(open[open.size() / 2] <= 0.01);
    CHECK(open[open.size() * 9 / 10] <= 0.04);
    CHECK(open.back() <= 0.06);
}

TEST_CASE("after a drop on a wall of few no dark part stays") {
    for (const std::size_t items : {std::size_t{3}, std::size_t{5}}) {
        const std::vector<double> open = open_after_drops({.items = items, .walls = 1});
        CHECK(open[open.size() / 2] <= 0.08);
        CHECK(open[open.size() * 9 / 10] <= 0.2);
    }
}

TEST_CASE("the others make way locally: none goes farther than a quarter of the diagonal, most stay") {
    std::vector<double> ways;
    Random random(5);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const WallState wall = planned_wall(12, seed);
        for (int k = 0; k < 8; ++k) {
            const std::size_t held = uniform_index(random, wall.items.size());
            Wish wish =
                wish_at(wall, held, {wall.canvas.x * uniform(random), wall.canvas.y * uniform(random)});
            wish.is_let_go = k % 2 == 0;
            const WallState next = made_way(wall, std::vector{wish}, quick_rules);
            CHECK(measured(next.items, next.placements).hidden == 0);
            for (std::size_t i = 0; i < wall.items.size(); ++i)
                if (i != held)
                    ways.push_back(
                        length(middle_of(wall, i, next.placements[i]) - middle_of(wall, i, wall.homes[i])) /
                        length(wall.canvas));
        }
    }
    std::ranges::sort(ways);
    CHECK(ways.back() <= 0.25);
    CHECK(ways[ways.size() / 2] <= 0.05);
}

TEST_CASE(
    "without wishes all are at home exactly; a wish leaves the homes, one that was let go changes them") {
    WallState wall = planned_wall(8, 4);
    wall.placements[2].offset.x += 40;
    CHECK(made_way(wall, {}, quick_rules).placements == wall.homes);
    Wish wish = wish_at(wall, 1, wall.canvas * 0.5);
    CHECK(made_way(wall, std::vector{wish}, quick_rules).homes == wall.homes);
    wish.is_let_go = true;
    const WallState after = made_way(wall, std::vector{wish}, quick_rules);
    CHECK(after.homes == after.placements);
    CHECK(after.homes != wall.homes);
}

TEST_CASE("ten wishes at once are given room together, and two on one another are not both heard") {
    const WallState wall = planned_wall(12, 6);
    std::vector<Wish> wishes;
    for (std::size_t i = 0; i < 10; ++i)
        wishes.push_back(wish_at(wall, i, {100.0 + 190 * static_cast<double>(i % 5), i < 5 ? 300.0 : 700.0}));
    wishes[3].at = wish_at(wall, 3, middle_of(wall, 2, wishes[2].at)).at;
    const WallState next = made_way(wall, wishes, quick_rules);
    CHECK(measured(next.items, next.placements).hidden == 0);
}

TEST_CASE("on a large wall only those near a wish move") {
    const WallState wall = planned_wall(80, 7);
    Wish wish = wish_at(wall, 10, middle_of(wall, 10, wall.homes[10]) + Vec2{60, 20});
    wish.is_let_go = true;
    const WallState next = made_way(wall, std::vector{wish}, quick_rules);
    CHECK(measured(next.items, next.placements).hidden == 0);
    long moved = 0;
    for (std::size_t i = 0; i < 80; ++i)
        moved += i != 10 && next.placements[i] != wall.placements[i] ? 1 : 0;
    CHECK(moved < 30);
}

TEST_CASE("shots that are let go together stay where that was, and have their sizes again") {
    std::vector<double> ways;
    std::vector<double> sizes;
    Random random(9);
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        WallState wall = planned_wall(12, seed);
        std::vector<Wish> wishes;
        for (const std::size_t item : {2U, 7U})
            wishes.push_back(
                wish_at(wall, item, {wall.canvas.x * uniform(random), wall.canvas.y * uniform(random)}));
        wall.placements = made_way(wall, wishes, quick_rules).placements;
        for (Wish& wish : wishes)
            wish = {.item = wish.item, .at = wall.placements[wish.item], .is_let_go = true};
        const WallState next = made_way(wall, wishes, quick_rules);
        CHECK(measured(next.items, next.placements).hidden == 0);
        for (const Wish& wish : wishes) {
            const Placement& end = next.placements[wish.item];
            ways.push_back(length(middle_of(wall, wish.item, end) - middle_of(wall, wish.item, wish.at)) /
                           length(wall.canvas));
            sizes.push_back(end.scale / wall.homes[wish.item].scale);
        }
    }
    CHECK(std::ranges::max(ways) <= 0.07);
    std::ranges::sort(sizes);
    CHECK(sizes[sizes.size() / 2] >= 0.95);
}
