#include "base/catalogue/record.hpp"
#include "base/catalogue/record_json.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

MediaRecord film() {
    return {.path = "a/b c.mp4",
            .kind = MediaKind::video,
            .bytes = 123,
            .mtime_ns = -5,
            .state = MediaState::ready,
            .reason = "",
            .width = 640,
            .height = 360,
            .duration = 3s,
            .shots = {{.begin = 0s,
                       .end = 2s,
                       .ends_with = ShotEnd::dissolve,
                       .region = {.polygon = {{1, 2}, {30.5, 2}, {3, 40}}, .drift = {10, -5}}}}};
}

}  // namespace

TEST_CASE("a record survives the way to JSON and back") {
    CHECK(record_from_json(to_json(film())) == film());
}

TEST_CASE("a path that is not UTF-8 survives the way to JSON and back") {
    MediaRecord record = film();
    record.path = "caf\xe9/\xff.jpg";
    CHECK(record_from_json(to_json(record)).path == record.path);
}

TEST_CASE("the JSON has the names of format version 2") {
    CHECK(
        to_json(film()) ==
        R"({"version":2,"path":"a/b c.mp4","kind":"video","bytes":123,"mtime_ns":-5,"state":"ready",)"
        R"("complete":true,"reason":"",)"
        R"("width":640,"height":360,"duration_ns":3000000000,"shots":[{"begin_ns":0,"end_ns":2000000000,)"
        R"("ends_with":"dissolve","region":{"polygon":[[1.0,2.0],[30.5,2.0],[3.0,40.0]],"drift":[10.0,-5.0]}}]})");
}

TEST_CASE("a record has grown where it says the same of the same content, and more behind") {
    MediaRecord before = film();
    before.is_complete = false;
    MediaRecord after = film();
    CHECK(is_grown_from(after, before));
    after.shots.push_back({.begin = 2s, .end = 3s});
    CHECK(is_grown_from(after, before));
    CHECK_FALSE(is_grown_from(before, after));
    MediaRecord other = after;
    other.shots[0].end = 1s;
    CHECK_FALSE(is_grown_from(other, before));
    other = after;
    other.mtime_ns = 7;
    CHECK_FALSE(is_grown_from(other, before));
}

TEST_CASE("text that is no record is refused, with the reason") {
    CHECK_THROWS_AS(record_from_json(""), std::runtime_error);
    CHECK_THROWS_AS(record_from_json("{}"), std::runtime_error);
    CHECK_THROWS_AS(record_from_json(R"({"version":99})"), std::runtime_error);
}

TEST_CASE("the core of a drifting shot is what every aligned frame shows") {
    // drift (10, -5) px/s over 2 s: the frame slides by (-20, +10) against the subject
    const MediaRecord record = film();
    const Box expected{{0, 10}, {620, 360}};
    CHECK(core(record, record.shots[0]) == expected);
}
