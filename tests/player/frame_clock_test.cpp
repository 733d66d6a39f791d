#include "player/frame_clock.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("pictures shown in time are due at the steady rate and none is late") {
    FrameClock clock(25);
    for (int i = 0; i < 50; ++i) {
        CHECK(clock.due() == i * 40ms);
        clock.advance(clock.due() + 5ms);
    }
    CHECK(clock.pictures() == 50);
    CHECK(clock.late() == 0);
}

TEST_CASE("a picture that takes three times as long costs the two whose time it took") {
    FrameClock clock(25);
    clock.advance(90ms);  // picture 0; those of 40 ms and 80 ms are over
    CHECK(clock.due() == 120ms);
    CHECK(clock.late() == 2);
    CHECK(clock.pictures() == 1);
}

TEST_CASE("time without a panel makes nothing late") {
    FrameClock clock(25);
    clock.skip_to(10s);
    CHECK(clock.due() == 10s + 40ms);
    CHECK(clock.late() == 0);
    CHECK(clock.pictures() == 0);
}

TEST_CASE("a clock paced by its pictures loses none, however long they take") {
    FrameClock clock(30);
    for (int i = 0; i < 30; ++i)
        clock.advance_exactly();
    CHECK(clock.due() == 1s);
    CHECK(clock.pictures() == 30);
}
