#include "analyzer/watch/film_growth.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

MediaRecord part(int first, int count, std::int64_t mtime = 1) {
    MediaRecord record{
        .path = "a.mp4", .kind = MediaKind::film, .mtime_ns = mtime, .state = MediaState::ready};
    record.is_complete = false;
    for (int i = first; i < first + count; ++i)
        record.shots.push_back({.begin = 1s * i, .end = 1s * (i + 1)});
    return record;
}

}  // namespace

TEST_CASE("parts are added behind each other, and are news once") {
    GrowingRecords growing;
    growing.begin(part(0, 0));
    CHECK_FALSE(growing.has_news());
    growing.add(part(0, 1));
    growing.add(part(1, 2));
    CHECK(growing.has_news());
    CHECK(growing.take_news() == std::vector{part(0, 3)});
    CHECK_FALSE(growing.has_news());
    CHECK(growing.take_news().empty());
}

TEST_CASE("a second try is no news until it knows more than the first") {
    GrowingRecords growing;
    growing.known(part(0, 2));
    growing.begin(part(0, 0));
    growing.add(part(0, 2));
    CHECK_FALSE(growing.has_news());
    growing.add(part(2, 1));
    CHECK(growing.take_news() == std::vector{part(0, 3)});
}

TEST_CASE("of another content the first shot is news") {
    GrowingRecords growing;
    growing.known(part(0, 2));
    growing.begin(part(0, 0, 9));
    growing.add(part(0, 1, 9));
    CHECK(growing.take_news() == std::vector{part(0, 1, 9)});
}

TEST_CASE("a shot whose place in the store becomes known is news, and stands where it stood") {
    GrowingRecords growing;
    growing.begin(part(0, 0));
    growing.add(part(0, 2));
    growing.take_news();
    MediaRecord stored = part(0, 1);
    stored.shots[0].stored = {.file = "0123456789abcdef/a.mp4", .width = 8, .height = 8};
    growing.add(stored);
    MediaRecord expected = part(0, 2);
    expected.shots[0].stored = stored.shots[0].stored;
    CHECK(growing.take_news() == std::vector{expected});
    CHECK(growing.take_news().empty());
}
