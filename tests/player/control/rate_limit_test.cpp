#include "player/control/rate_limit.hpp"

#include <doctest/doctest.h>

using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("however often it is asked for, it happens once a second") {
    RateLimit limit(1s);
    int turns = 0;
    for (auto now = 0ms; now < 10s; now += 7ms)
        if (limit.take_turn(now)) ++turns;
    CHECK(turns == 10);
    CHECK(limit.take_turn(1h));
    CHECK_FALSE(limit.take_turn(1h + 999ms));
}
