#include "player/scene/programme.hpp"

#include "base/hints/hint_words.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

std::chrono::local_seconds at(unsigned day, std::chrono::seconds time) {
    return std::chrono::local_days(std::chrono::year(2026) / std::chrono::month(12) / std::chrono::day(day)) +
           time;
}

std::vector<std::string> paths(const Programme& programme) {
    std::vector<std::string> paths;
    for (const MediaRecord& record : programme.open())
        paths.push_back(record.path);
    return paths;
}

using Paths = std::vector<std::string>;

}  // namespace

TEST_CASE("files come and go at their hours, and the choice is new only then") {
    Programme programme;
    programme.set_records({photo("08-18 day/a"), photo("18-08 night/b"), photo("c")});
    CHECK(programme.advance(at(1, 17h + 59min + 59s)));
    CHECK(paths(programme) == Paths{"08-18 day/a", "c"});
    CHECK_FALSE(programme.advance(at(1, 17h + 59min + 59s)));
    CHECK(programme.advance(at(1, 18h)));
    CHECK(paths(programme) == Paths{"18-08 night/b", "c"});
    CHECK_FALSE(programme.advance(at(1, 23h)));
    CHECK(programme.advance(at(2, 8h)));
    CHECK(paths(programme) == Paths{"08-18 day/a", "c"});
    CHECK(programme.count() == 3);
    CHECK(programme.count_open() == 2);
}

TEST_CASE("without a clock only what is shown at any time is shown") {
    Programme programme;
    programme.set_records({photo("2020-01-01.. a"), photo("b")});
    CHECK(programme.advance(std::nullopt));
    CHECK(paths(programme) == Paths{"b"});
    CHECK(programme.advance(at(1, 0s)));
    CHECK(paths(programme) == Paths{"2020-01-01.. a", "b"});
    // a clock that runs ahead is followed, and comes back
    CHECK_FALSE(programme.advance(at(1, 0s) + std::chrono::years(50)));
    programme.set_records({photo("2026-12-01..2026-12-24 a"), photo("b")});
    CHECK(programme.advance(at(1, 0s) + std::chrono::years(50)));
    CHECK(paths(programme) == Paths{"b"});
    CHECK(programme.advance(at(2, 0s)));
    CHECK(paths(programme).size() == 2);
}

TEST_CASE("what folders say counts as soon as it is known, and is handed on") {
    Programme programme;
    programme.set_records({photo("a/x"), photo("b/3x y")});
    CHECK(programme.advance(at(1, 12h)));
    programme.set_folders({{"a", hints_in_name("18-20 5s", NamePart::folder)}});
    CHECK(programme.advance(at(1, 12h)));
    CHECK(paths(programme) == Paths{"b/3x y"});
    CHECK(programme.hints().at("b/3x y").repeat == 3);
    programme.set_folders({});
    CHECK(programme.advance(at(1, 12h)));
    CHECK(paths(programme).size() == 2);
}

TEST_CASE("where nothing has a time the choice stays as it is") {
    Programme programme;
    programme.set_records({photo("20s a")});
    CHECK(programme.advance(std::nullopt));
    CHECK_FALSE(programme.is_scheduled());
    CHECK_FALSE(programme.advance(at(1, 0s)));
}
