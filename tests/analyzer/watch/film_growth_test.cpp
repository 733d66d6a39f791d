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
    FilmGrowth growth(part(0, 0));
    CHECK_FALSE(growth.take_news());
    growth.add_shots(part(0, 1));
    growth.add_shots(part(1, 2));
    CHECK(growth.take_news() == part(0, 3));
    CHECK_FALSE(growth.take_news());
}

TEST_CASE("a second try is no news until it knows more than the first") {
    FilmGrowth growth = FilmGrowth::published(part(0, 2));
    growth.begin_analysis(part(0, 0));
    growth.add_shots(part(0, 2));
    CHECK_FALSE(growth.take_news());
    growth.add_shots(part(2, 1));
    CHECK(growth.take_news() == part(0, 3));
}

TEST_CASE("of another content the first shot is news") {
    FilmGrowth growth = FilmGrowth::published(part(0, 2));
    growth.begin_analysis(part(0, 0, 9));
    growth.add_shots(part(0, 1, 9));
    CHECK(growth.take_news() == part(0, 1, 9));
}

TEST_CASE("a shot whose place in the store becomes known is news, and stands where it stood") {
    FilmGrowth growth(part(0, 0));
    growth.add_shots(part(0, 2));
    growth.take_news();
    MediaRecord stored = part(0, 1);
    stored.shots[0].stored = {.file = "0123456789abcdef/a.mp4", .width = 8, .height = 8};
    growth.add_shots(stored);
    MediaRecord expected = part(0, 2);
    expected.shots[0].stored = stored.shots[0].stored;
    CHECK(growth.take_news() == expected);
    CHECK_FALSE(growth.take_news());
}
