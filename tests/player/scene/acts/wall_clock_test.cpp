#include "player/scene/acts/wall_clock.hpp"

#include <doctest/doctest.h>

using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::nanoseconds noon = 1'800'000'000s;

}  // namespace

TEST_CASE("shared time is real time where that is kept right, and begins at a whole second") {
    WallClock clock({.steady = 5s, .real = noon + 300ms, .is_right = true});
    CHECK(clock.epoch() == noon);
    CHECK(clock.now() == 300ms);
    clock.follow({.steady = 6s, .real = noon + 1300ms, .is_right = true}, false);
    CHECK(clock.now() == 1300ms);
    CHECK(clock.is_right());
}

TEST_CASE("a small difference is made up slowly") {
    WallClock clock({.steady = 0s, .real = noon, .is_right = true});
    clock.follow({.steady = 1s, .real = noon + 950ms, .is_right = true}, true);
    CHECK(clock.now() == 990ms);
    CHECK(clock.difference() == -40ms);
    for (int k = 2; k < 10; ++k)
        clock.follow({.steady = k * 1s, .real = noon + k * 1s - 50ms, .is_right = true}, true);
    CHECK(clock.difference() == 0s);
}

TEST_CASE("a large difference is made up between acts, and the time never goes back nor far ahead") {
    WallClock clock({.steady = 0s, .real = noon + 100ms, .is_right = true});
    for (const auto away : {37'300ms, -37'300ms, 86'400'000ms}) {
        const auto before = clock.now();
        const auto steady = before - 100ms + 10ms;
        clock.follow({.steady = steady, .real = noon + before + 10ms + away, .is_right = true}, false);
        CHECK(clock.now() == before + 10ms);
        clock.follow({.steady = steady, .real = noon + before + 10ms + away, .is_right = true}, true);
        CHECK(clock.now() >= before + 10ms);
        CHECK(clock.now() <= before + 1010ms);
        CHECK(clock.epoch() + clock.now() == noon + before + 10ms + away);
        clock = WallClock({.steady = 0s, .real = noon + 100ms, .is_right = true});
    }
}

TEST_CASE("a clock that nobody keeps right is not followed") {
    WallClock clock({.steady = 0s, .real = noon, .is_right = false});
    clock.follow({.steady = 1s, .real = noon + 500s, .is_right = false}, true);
    CHECK(clock.now() == 1s);
    CHECK(clock.epoch() == noon);
    CHECK_FALSE(clock.is_right());
    CHECK(clock.difference() == 499s);
}
