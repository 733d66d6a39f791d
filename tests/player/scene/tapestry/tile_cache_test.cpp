#include "player/scene/tapestry/tile_cache.hpp"

#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Box box{{0, 0}, {320, 90}};

std::ptrdiff_t rank(const std::vector<TileId>& order, const TileId& tile) {
    return std::ranges::find(order, tile) - order.begin();
}

}  // namespace

TEST_CASE("what is seen is wanted first, then the coarsest level, then what is near in place and in level") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const TapestryView view{.centre = 25s, .level = 2};
    const std::vector<TileId> order = wanted_tiles(place, view, 0, 1000);

    const auto seen = place.tiles(view, 2, 0, 320);
    for (const auto& [tile, x] : seen)
        CHECK(rank(order, tile) < std::ssize(seen));
    CHECK(order[seen.size()].level == 0);
    const auto count = [&](std::size_t level) {
        return std::ranges::count(order, level, [](const TileId& tile) { return tile.level; });
    };
    CHECK(count(2) > std::ssize(seen));
    CHECK(count(1) > 0);
    CHECK(count(3) > 0);
    CHECK(std::set<TileId>(order.begin(), order.end()).size() == order.size());
}

TEST_CASE("tiles where the view goes to come before those that it leaves") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const TapestryView view{.centre = 30s, .level = 3};
    const auto tiles = place.tiles(view, 3, -300, 620);
    const TileId left = tiles.front().first;
    const TileId right = tiles.back().first;
    const auto right_first = wanted_tiles(place, view, 1, 1000);
    CHECK(rank(right_first, right) < rank(right_first, left));
    const auto left_first = wanted_tiles(place, view, -1, 1000);
    CHECK(rank(left_first, left) < rank(left_first, right));
}

TEST_CASE("between two levels both are wanted before anything else, and never more than there is room for") {
    const Tapestry tapestry = drawn_tapestry();
    const TapestryPlace place(tapestry, box);
    const TapestryView view{.centre = 30s, .level = 1.5};
    const auto order = wanted_tiles(place, view, 0, 4);
    CHECK(order.size() == 4);
    for (const TileId& tile : order)
        CHECK((tile.level == 1 || tile.level == 2));
}

TEST_CASE("a cache never holds more than it may, and keeps what was wanted last") {
    TileCache cache(3);
    for (int k = 0; k < 20; ++k) {
        const std::vector<TileId> wanted{{1, k}, {1, k + 1}};
        cache.set_wanted(wanted);
        for (const TileId& tile : cache.missing())
            cache.add(tile);
        CHECK(cache.missing().empty());
        CHECK(cache.size() <= 3);
        CHECK(cache.has({1, k}));
        CHECK(cache.has({1, k + 1}));
    }
    CHECK(cache.has({1, 18}));
    CHECK_FALSE(cache.has({1, 17}));
}

TEST_CASE("a tile that comes when nobody wants it any more is not kept") {
    TileCache cache(8);
    cache.set_wanted(std::vector<TileId>{{0, 1}});
    cache.set_wanted(std::vector<TileId>{{0, 2}});
    CHECK(cache.add({0, 1}) == std::vector<TileId>{{0, 1}});
    CHECK(cache.size() == 0);
    CHECK(cache.missing() == std::vector<TileId>{{0, 2}});
}

TEST_CASE("what there is no room for is not missing") {
    TileCache cache(2);
    cache.set_wanted(std::vector<TileId>{{0, 1}, {0, 2}, {0, 3}});
    CHECK(cache.missing() == std::vector<TileId>{{0, 1}, {0, 2}});
}
