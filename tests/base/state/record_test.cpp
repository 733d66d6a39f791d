#include "base/state/name_hash.hpp"
#include "base/state/path_text.hpp"
#include "base/state/record.hpp"
#include "base/state/record_json.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

MediaRecord film() {
    return {.path = "a/b c.mp4",
            .kind = MediaKind::film,
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

TEST_CASE(
    "titles and what lies between shots survive the way to JSON and back; a record without them is read") {
    MediaRecord record = film();
    record.shots[0].is_title = true;
    record.shots[0].ends_with = ShotEnd::split;
    record.between = {{2s, 2500ms, StretchKind::transition},
                      {2500ms, 2800ms, StretchKind::plain},
                      {2800ms, 3s, StretchKind::empty}};
    CHECK(record_from_json(to_json(record)) == record);
    CHECK(record_from_json(to_json(film())).between.empty());
}

TEST_CASE("a path that is not UTF-8 survives the way to JSON and back") {
    MediaRecord record = film();
    record.path = "caf\xe9/\xff.jpg";
    CHECK(record_from_json(to_json(record)).path == record.path);
}

TEST_CASE("the JSON has the names of format version 3") {
    CHECK(
        to_json(film()) ==
        R"({"version":3,"path":"a/b c.mp4","kind":"video","bytes":123,"mtime_ns":-5,"state":"ready",)"
        R"("complete":true,"reason":"",)"
        R"("width":640,"height":360,"duration_ns":3000000000,"shots":[{"begin_ns":0,"end_ns":2000000000,)"
        R"("ends_with":"dissolve","region":{"polygon":[[1.0,2.0],[30.5,2.0],[3.0,40.0]],"drift":[10.0,-5.0]},"analysis":12}]})");
}

TEST_CASE(
    "where a shot is stored survives the way to JSON and back, and names no file outside of the store") {
    const StoredShot clip{.file = "0123456789abcdef/0-2000000000.mp4", .width = 320, .height = 180};
    MediaRecord record = film();
    record.shots[0].stored = clip;
    CHECK(record_from_json(to_json(record)) == record);
    for (const char* file : {"", "0123456789abcdef", "0123456789abcdef/", "0123456789abcdef/..",
                             "0123456789abcdef/.x", "0123456789abcdef/a/b", "../456789abcdef/a.mp4",
                             "0123456789ABCDEF/a.mp4", "/etc/passwd", "0123456789abcdef/a b"}) {
        CAPTURE(file);
        record.shots[0].stored->file = file;
        CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
    }
}

TEST_CASE("a record that only says where its shots are stored has grown from one that did not") {
    const MediaRecord before = film();
    MediaRecord after = before;
    after.shots[0].stored = {.file = "0123456789abcdef/a.mp4", .width = 320, .height = 180};
    CHECK(is_grown_from(after, before));
    CHECK(is_grown_from(before, after));
}

TEST_CASE("the store knows a file by its name and its content") {
    CHECK(store_id("a.mp4", 1, 2) == store_id("a.mp4", 1, 2));
    CHECK(store_id("a.mp4", 1, 2) != store_id("b.mp4", 1, 2));
    CHECK(store_id("a.mp4", 1, 2) != store_id("a.mp4", 2, 2));
    CHECK(store_id("a.mp4", 1, 2) != store_id("a.mp4", 1, 3));
    CHECK(is_store_name(store_id("a.mp4", 1, 2) + "/a.mp4"));
}

TEST_CASE("nobody can make up a name that shares its record with another") {
    CHECK(name_hash("abc") == "ba7816bf8f01cfea414140de5dae2223");  // the begin of SHA-256's own example
    const std::string one = from_hex("d1562a5124cec7453a5296093bbc56af");  // they shared one in version 0.1
    const std::string other = from_hex("b93942ea7b73826718172b5680d439c7");
    CHECK(record_id(one) != record_id(other));
}

TEST_CASE("what version 0.1 has stored is still played") {
    CHECK(is_store_name("0123456789abcdef/a.mp4"));
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

TEST_CASE("the certainty of a photo's region survives the way to JSON, and is a share") {
    MediaRecord record = film();
    CHECK_FALSE(record_from_json(to_json(record)).shots[0].certainty);
    record.shots[0].certainty = 0.875;
    CHECK(record_from_json(to_json(record)) == record);
    record.shots[0].certainty = 7;  // from a damaged record
    CHECK(record_from_json(to_json(record)).shots[0].certainty == 1);
}

TEST_CASE("a shot's picture within its bars survives the way to JSON, and its core lies in it") {
    MediaRecord record = film();
    record.shots[0].picture = Box{{0, 40}, {640, 320}};
    CHECK(record_from_json(to_json(record)) == record);
    const Box expected{{0, 50}, {620, 320}};
    CHECK(core(record, record.shots[0]) == expected);
    CHECK_FALSE(is_grown_from(record, film()));
    record.shots[0].picture = Box{{700, 40}, {800, 320}};  // from a damaged record
    const Box whole{{0, 0}, {640, 360}};
    CHECK(active_picture(record, record.shots[0]) == whole);
    record.shots.push_back({.begin = 2s, .end = 3s, .region = {}, .picture = Box{{80, 0}, {560, 360}}});
    record.shots[0].picture = Box{{0, 40}, {640, 320}};
    CHECK(active_picture(record) == whole);
}

TEST_CASE("a shot that does not name its analysis is of an earlier version, and its record is outdated") {
    MediaRecord record{.path = "a", .state = MediaState::ready, .width = 4, .height = 3, .shots = {Shot{}}};
    CHECK_FALSE(is_outdated(record_from_json(to_json(record))));
    std::string earlier = to_json(record);
    const std::string key = R"(,"analysis":12)";
    const std::size_t at = earlier.find(key);
    REQUIRE(at != std::string::npos);
    earlier.erase(at, key.size());
    CHECK(is_outdated(record_from_json(earlier)));
    record.shots.front().analysis = Shot::current_analysis - 1;
    CHECK(is_outdated(record));
    record.kind = MediaKind::film;
    CHECK(is_outdated(record));
    record.state = MediaState::failed;
    record.shots.front().analysis = 1;
    CHECK_FALSE(is_outdated(record));
}

TEST_CASE("a record keeps the caption of its photo, and has no key where there is none") {
    MediaRecord record{.path = "a"};
    CHECK(to_json(record).find("caption") == std::string::npos);
    record.origin.caption = "Oma \"am\" Fluß";
    CHECK(record_from_json(to_json(record)) == record);
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

TEST_CASE("the look of a shot survives the way to JSON, and one of another length is no record") {
    MediaRecord record = film();
    CHECK_FALSE(record_from_json(to_json(record)).shots[0].look);
    ShotLook look{.hash = 0x8123456789abcdefU};
    look.colours[0] = 255;
    look.colours[26] = 7;
    record.shots[0].look = look;
    const std::string text = to_json(record);
    CHECK(record_from_json(text).shots[0].look == look);
    CHECK(is_grown_from(record, record_from_json(to_json(film()))));
    CHECK_THROWS_AS(static_cast<void>(look_from_text("8123")), std::runtime_error);
}

TEST_CASE("looks are as far apart as their colours and hashes, and no farther than 1") {
    ShotLook dark;
    ShotLook bright{.hash = ~std::uint64_t{0}};
    bright.colours.fill(255);
    CHECK(distance_between(dark, dark) == 0);
    CHECK(distance_between(dark, bright) == 1);
    bright.hash = 0;
    CHECK(distance_between(dark, bright) == doctest::Approx(0.5));
}

TEST_CASE("the time at which a medium was taken survives the way to JSON and back") {
    MediaRecord record = film();
    CHECK_FALSE(record_from_json(to_json(record)).origin.taken);
    record.origin = {.taken =
                         TimeTaken{.at = std::chrono::sys_days(std::chrono::year(2023) / 5 / 1) + 10h + 5ms,
                                   .zone = -210min,
                                   .source = TimeSource::camera_clock},
                     .content_id = "A-1"};
    CHECK(record_from_json(to_json(record)) == record);
    record.origin.content_id = "../x";
    CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
}

TEST_CASE("the print of a photo survives the way to JSON, and one of another length is no record") {
    MediaRecord record = film();
    record.shots[0].print =
        PicturePrint{.shades = std::vector<std::uint8_t>(std::size_t{16} * 16, 7), .sharpness = 12.5};
    CHECK(record_from_json(to_json(record)) == record);
    record.shots[0].print->shades.pop_back();
    CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
}

TEST_CASE("the film in a photo survives the way to JSON, and one without a size or a time is no record") {
    MediaRecord record{.path = "a.jpg", .state = MediaState::ready, .width = 40, .height = 30};
    record.film = InnerFilm{.shot = film().shots[0], .width = 16, .height = 9};
    CHECK(record_from_json(to_json(record)) == record);
    record.film->width = 0;
    CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
    record.film->width = 16;
    record.film->shot.end = record.film->shot.begin;
    CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
}

TEST_CASE("the marks of a photo survive the way to JSON, and too many are no record") {
    MediaRecord record = film();
    record.shots[0].marks = {{{1, 2}, {30, 40}}, {{5, 6}, {7, 8.5}}};
    CHECK(record_from_json(to_json(record)) == record);
    record.shots[0].marks.resize(Shot::max_marks + 1);
    CHECK_THROWS_AS(record_from_json(to_json(record)), std::runtime_error);
}
