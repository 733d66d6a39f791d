#include "player/stage/show_switch.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/unique_fd.hpp"
#include "tests/player/scene/scene_media.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

TEST_CASE("a file that is not there is told once in ten minutes, however often it is asked for") {
    const TemporaryDirectory directory;
    const auto file = directory.write("said", "");
    const Settings settings;
    ShowSwitch shows(settings, 0, false);
    const UniqueFd kept(::dup(STDERR_FILENO));
    const UniqueFd said(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    REQUIRE(::dup2(said.get(), STDERR_FILENO) >= 0);
    for (std::chrono::nanoseconds now{0}; now < 15min; now += 3s) {
        shows.set_time(now);
        for (const SourceId source : {1, 2})
            shows.handle_source_event(
                {.source = source, .failure = "open 'a.jpg': No such file", .unstored = {}});
    }
    REQUIRE(::dup2(kept.get(), STDERR_FILENO) >= 0);
    const std::string text = read_file(file);
    CHECK(std::ranges::count(text, '\n') == 4);
    CHECK(text.find("a.jpg") != std::string::npos);
}

TEST_CASE("a tapestry is opened on a wall that leads other boxes, too") {
    const TemporaryDirectory directory;
    Settings settings;
    settings.state.directory = directory.path.string();
    const RecordList films({film("f", 1)});
    for (const WallRole role : {WallRole::alone, WallRole::lead}) {
        settings.wall.role = role;
        ShowSwitch shows(settings, 0, false);
        shows.set_time(10s);
        CHECK(shows.open_tapestry(films.find("f"), 0, {}) == Opening::opened);
        CHECK(shows.tapestry() != nullptr);
    }
}

TEST_CASE("a box that follows shows the leader's tapestry as long as the leader does") {
    const TemporaryDirectory directory;
    Settings settings;
    settings.state.directory = directory.path.string();
    settings.wall.role = WallRole::follow;
    const RecordList films({film("f", 1), film("g", 1)});
    ShowSwitch shows(settings, 0, false);
    const auto follow = [&](std::chrono::nanoseconds now, const TapestryMoment* seen) {
        shows.set_time(now);
        shows.follow_tapestry(seen, seen != nullptr ? films.find(seen->path) : nullptr);
        shows.leave_finished_tapestry();
        return shows.tapestry() != nullptr ? shows.tapestry()->show().film().path : std::string();
    };
    const TapestryMoment one{.path = "f", .room = {640, 360}, .opened = 10s};
    const TapestryMoment other{.path = "g", .room = {640, 360}, .opened = 30s};
    const TapestryMoment unknown{.path = "h", .room = {640, 360}, .opened = 50s};
    CHECK(follow(5s, nullptr).empty());
    CHECK(follow(10s, &one) == "f");
    CHECK(shows.tapestry()->show().place().box().max.x == 640);
    CHECK(follow(20s, &one) == "f");
    CHECK(follow(30s, &other).empty());  // the wall first: one fade after the other
    for (std::chrono::nanoseconds now = 30s; now < 35s; now += 40ms)
        follow(now, &other);
    CHECK(follow(35s, &other) == "g");
    CHECK(follow(40s, nullptr).empty());
    CHECK(follow(50s, &unknown).empty());
}
