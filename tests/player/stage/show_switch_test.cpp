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

TEST_CASE("no tapestry is opened on a wall that leads other boxes") {
    const TemporaryDirectory directory;
    Settings settings;
    settings.state.directory = directory.path.string();
    const RecordList films({film("f", 1)});
    for (const WallRole role : {WallRole::alone, WallRole::lead}) {
        settings.wall.role = role;
        ShowSwitch shows(settings, 0, false);
        shows.set_time(10s);
        CHECK(shows.open_tapestry(films.find("f"), 0) == (role == WallRole::alone));
        CHECK((shows.tapestry() != nullptr) == (role == WallRole::alone));
    }
}
