#include "player/content/calendar.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/machine.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
using std::chrono::system_clock;
using std::chrono::years;

namespace fs = std::filesystem;

TEST_CASE("no clock is believed that is earlier than the program or its newest record") {
    const system_clock::time_point built = system_clock::time_point(1'800'000'000s);
    EarliestTime earliest(built);
    CHECK(earliest.time() == built);
    earliest.record_written(built - 100h);
    CHECK(earliest.time() == built);
    earliest.record_written(built + 500h);
    earliest.record_written(built + 400h);
    CHECK(earliest.time() == built + 500h);
}

TEST_CASE("a record that was written while the clock was 50 years ahead proves nothing") {
    const system_clock::time_point built = system_clock::time_point(1'800'000'000s);
    EarliestTime earliest(built);
    earliest.record_written(built + years(50));
    CHECK(earliest.time() == built);
}

TEST_CASE("the time is known where nothing speaks against it, and unknown before the newest record") {
    const TemporaryDirectory directory;
    CHECK(Calendar(directory.path / "none").now());
    replace_file(directory.path / "a.json", "{}");
    CHECK(Calendar(directory.path).now());
    if (is_clock_kept_right()) return;  // this clock is believed in any case
    fs::last_write_time(directory.path / "a.json", fs::file_time_type::clock::now() + 240h);
    CHECK_FALSE(Calendar(directory.path).now());
    fs::last_write_time(directory.path / "a.json", fs::file_time_type::clock::now() + years(50));
    CHECK(Calendar(directory.path).now());
}
