#include "player/control/health.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// Screens that flip or do not, looked at every 100 ms.
struct Watched {
    Health health;
    std::vector<ScreenState::Screen> screens{};
    std::vector<bool> flips{};  // true: this screen flips
    bool is_away = false;
    std::size_t items = 4;
    std::chrono::nanoseconds now = 0s;

    void plug(bool does_flip) {
        screens.push_back({.name = "HDMI-A-" + std::to_string(screens.size() + 1)});
        flips.push_back(does_flip);
    }

    /// The number of times that systemd is told in this time.
    int run(std::chrono::nanoseconds duration) {
        int fed = 0;
        for (const auto end = now + duration; now < end; now += 100ms) {
            for (std::size_t i = 0; i < screens.size(); ++i)
                screens[i].flips += flips[i] ? 1 : 0;
            health.set_screens({.screens = screens, .is_away = is_away, .items = items}, now);
            fed += health.feed_watchdog_now(now) ? 1 : 0;
        }
        return fed;
    }
};

}  // namespace

TEST_CASE("systemd is told once a second while pictures reach the display") {
    Watched watched;
    watched.plug(true);
    CHECK(watched.run(10s) >= 9);
    CHECK(watched.run(10s) <= 10);
    CHECK(watched.health.state() == ShowState::showing);
}

TEST_CASE("a display that takes no picture any more is not fed for, whatever else goes on") {
    Watched watched;
    watched.plug(true);
    watched.run(10s);
    watched.flips[0] = false;
    watched.run(6s);
    CHECK(watched.health.state() == ShowState::no_flip);
    CHECK(watched.run(60s) == 0);
    watched.flips[0] = true;
    CHECK(watched.run(3s) > 0);
    CHECK(watched.health.state() == ShowState::showing);
}

TEST_CASE("one of two displays that takes no picture is enough") {
    Watched watched;
    watched.plug(true);
    watched.plug(false);
    CHECK(watched.run(60s) == 0);
    CHECK(watched.health.state() == ShowState::no_flip);
}

TEST_CASE("without a panel all is well, and so it is while another has the display") {
    Watched watched;
    CHECK(watched.run(10s) == 10);
    CHECK(watched.health.state() == ShowState::no_panel);
    watched.plug(false);
    watched.is_away = true;
    CHECK(watched.run(60s) == 60);
    CHECK(watched.health.state() == ShowState::off);
}

TEST_CASE("the idle picture of a wall without content must reach the display as well") {
    Watched watched;
    watched.items = 0;
    watched.plug(true);
    CHECK(watched.run(10s) >= 9);
    CHECK(watched.health.state() == ShowState::no_content);
    watched.flips[0] = false;
    watched.run(6s);
    CHECK(watched.run(60s) == 0);
}

TEST_CASE("a picture a second is enough for a wall that stands still") {
    Watched watched;
    watched.plug(false);
    int fed = 0;
    for (int second = 0; second < 30; ++second) {
        ++watched.screens[0].flips;
        fed += watched.run(1s);
    }
    CHECK(fed >= 28);
    CHECK(watched.health.state() == ShowState::showing);
}

TEST_CASE("a display that is swapped has its own time to show the first picture") {
    Watched watched;
    watched.plug(true);
    watched.run(10s);
    watched.screens[0] = {.name = "DP-1"};
    watched.flips[0] = false;
    watched.run(4s);
    CHECK(watched.health.state() == ShowState::showing);
    watched.run(2s);
    CHECK(watched.health.state() == ShowState::no_flip);
}
