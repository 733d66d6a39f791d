#include "player/input/touch.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("a device that is not there is told of once, and the rest goes on") {
    Touch touch("/nowhere/event0, /nowhere/event1");
    CHECK(touch.event_fd() >= 0);
    CHECK(touch.read_events().empty());
    const std::vector<std::string> news = touch.take_news();
    REQUIRE(news.size() >= 2);
    CHECK(news[0].find("/nowhere/event0") != std::string::npos);
    CHECK(news[1].find("/nowhere/event1") != std::string::npos);
    CHECK(touch.read_events().empty());
    CHECK(touch.take_news().empty());
}

TEST_CASE("devices are left to another terminal and taken back") {
    Touch touch("/nowhere/event0");
    touch.suspend();
    CHECK(touch.read_events().empty());
    touch.resume();
    CHECK(touch.read_events().empty());
}
