#include "base/state/tapestry.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

namespace vitrine {
namespace {

using std::chrono::nanoseconds;
using std::chrono::seconds;

Tapestry drawn() {
    return {.path = "a film.mp4",
            .bytes = 12,
            .mtime_ns = 34,
            .duration = seconds(100),
            .is_complete = true,
            .folder = "tiles-1",
            .height = 150,
            .tile_width = 512,
            .brick_width = 100,
            .levels = {{.width = 150, .keyframes = {seconds(10), seconds(60)}},
                       {.width = 250, .keyframes = {seconds(10), seconds(20), seconds(30), seconds(60)}}}};
}

}  // namespace

TEST_CASE("times and places of a strip follow each other from keyframe to keyframe") {
    const Tapestry tapestry = drawn();

    CHECK(tapestry.x_at(0, seconds(0)) == 0);
    CHECK(tapestry.x_at(0, seconds(10)) == 50);
    CHECK(tapestry.x_at(0, seconds(35)) == 75);
    CHECK(tapestry.x_at(0, seconds(100)) == 150);
    CHECK(tapestry.x_at(1, seconds(60)) == 200);
    CHECK(tapestry.x_at(0, seconds(-5)) == 0);
    for (std::size_t level = 0; level < 2; ++level) {
        nanoseconds before{-1};
        for (double x = 0; x <= tapestry.levels[level].width; x += 12.5) {
            const nanoseconds time = tapestry.time_at(level, x);
            CHECK(time > before);
            CHECK(tapestry.x_at(level, time) == doctest::Approx(x));
            before = time;
        }
        CHECK(tapestry.time_at(level, 1e9) == seconds(100));
    }
}

TEST_CASE("a strip of a single keyframe has it in its middle") {
    Tapestry tapestry = drawn();
    tapestry.levels = {{.width = 150, .keyframes = {seconds(0)}}};

    CHECK(tapestry.middle(0, 0) == 75);
    CHECK(tapestry.time_at(0, 10) < std::chrono::milliseconds(1));
    CHECK(tapestry.time_at(0, 150) == seconds(100));
}

TEST_CASE("half a brick before a keyframe at the film's begin, and behind one at its end, can be looked at") {
    Tapestry tapestry = drawn();
    tapestry.levels[1].keyframes = {seconds(0), seconds(20), seconds(30), seconds(100)};

    CHECK(tapestry.x_at(1, seconds(0)) == 0);
    CHECK(tapestry.x_at(1, seconds(100)) == 250);
    CHECK(tapestry.x_at(1, tapestry.keyframe_time(1, 0)) == doctest::Approx(50));
    CHECK(tapestry.x_at(1, tapestry.keyframe_time(1, 3)) == doctest::Approx(200));
    for (const double x : {0.0, 10.0, 49.0, 50.0, 51.0, 120.0, 201.0, 240.0, 250.0})
        CHECK(tapestry.x_at(1, tapestry.time_at(1, x)) == doctest::Approx(x).epsilon(1e-3));
}

TEST_CASE("an index says which frames are kept, and where the one nearest to a moment is") {
    Tapestry tapestry = drawn();
    tapestry.kept = {.width = 100, .height = 50, .columns = 2, .rows = 2, .times = {}};
    for (int frame = 0; frame < 9; ++frame)
        tapestry.kept.times.push_back(seconds(10 * frame));
    tapestry.digits = {.width = 30, .height = 48};
    const Tapestry read = tapestry_from_json(to_json(tapestry));

    CHECK(to_json(read) == to_json(tapestry));
    CHECK(read.kept.sheets() == 3);
    CHECK(read.kept.nearest(seconds(-1)) == 0);
    CHECK(read.kept.nearest(seconds(44)) == 4);
    CHECK(read.kept.nearest(seconds(46)) == 5);
    CHECK(read.kept.nearest(seconds(100)) == 8);
    CHECK(read.sheet_name(2) == "tiles-1/frames/000002.jpg");
    CHECK(tapestry_from_json(to_json(drawn())).kept.is_empty());
    tapestry.kept.columns = 1000;
    CHECK_THROWS_AS(tapestry_from_json(to_json(tapestry)), std::runtime_error);
}

TEST_CASE("an index is read as it was written") {
    const TemporaryDirectory folder;
    const Tapestry tapestry = drawn();
    write_tapestry(folder.path, tapestry);
    const Tapestry read = read_tapestry(folder.path);

    CHECK(to_json(read) == to_json(tapestry));
    CHECK(read.levels[1].keyframes == tapestry.levels[1].keyframes);
    CHECK(read.tiles(0) == 1);
    CHECK(read.tile_name(1, 0) == "tiles-1/1/000000.jpg");
}

TEST_CASE("an index that says what cannot be is refused, and named") {
    const TemporaryDirectory folder;
    for (const auto& [from, into] : {std::pair{"\"version\":1", "\"version\":9"},
                                     {"tiles-1", "../etc"},
                                     {"\"tile_width\":512", "\"tile_width\":0"},
                                     {"20000000000", "90000000000"}}) {
        std::string json = to_json(drawn());
        const std::size_t place = json.find(from);
        REQUIRE(place != std::string::npos);
        const char* to = into;
        json.replace(place, std::string(from).size(), to);
        folder.write("index.json", json);
        CAPTURE(to);
        CHECK_THROWS_WITH(read_tapestry(folder.path), doctest::Contains("index.json"));
    }
}

}  // namespace vitrine
