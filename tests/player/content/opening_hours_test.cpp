#include "player/content/opening_hours.hpp"

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

using Paths = std::vector<std::string>;

/// Opening hours of files that the analyzer knows.
struct House {
    void set_files(const Paths& paths) {
        files = paths;
        std::vector<MediaRecord> records;
        for (const std::string& path : paths)
            records.push_back(photo(path));
        hours.set_files(records);
    }

    Paths open() const {
        Paths open;
        for (const std::string& path : files)
            if (hours.is_open(path)) open.push_back(path);
        return open;
    }

    OpeningHours hours;
    Paths files;
};

}  // namespace

TEST_CASE("files come and go at their hours, and the choice is new only then") {
    House house;
    house.set_files({"08-18 day/a", "18-08 night/b", "c"});
    CHECK(house.hours.advance(at(1, 17h + 59min + 59s)));
    CHECK(house.open() == Paths{"08-18 day/a", "c"});
    CHECK_FALSE(house.hours.advance(at(1, 17h + 59min + 59s)));
    CHECK(house.hours.advance(at(1, 18h)));
    CHECK(house.open() == Paths{"18-08 night/b", "c"});
    CHECK_FALSE(house.hours.advance(at(1, 23h)));
    CHECK(house.hours.advance(at(2, 8h)));
    CHECK(house.open() == Paths{"08-18 day/a", "c"});
    CHECK_FALSE(house.hours.is_open("18-08 night/b"));
}

TEST_CASE("files of weekdays come and go at midnight, and a holiday is a Sunday") {
    House house;
    house.hours = OpeningHours({std::chrono::local_days(std::chrono::year(2026) / 12 / 25)});
    house.set_files({"Mo-Fr menu/a", "Sat,Sun brunch/b"});
    CHECK(house.hours.advance(at(24, 23h)));  // a Thursday
    CHECK(house.open() == Paths{"Mo-Fr menu/a"});
    CHECK(house.hours.advance(at(25, 0h)));
    CHECK(house.open() == Paths{"Sat,Sun brunch/b"});
    CHECK_FALSE(house.hours.advance(at(26, 12h)));
    CHECK(house.hours.advance(at(28, 0h)));
    CHECK(house.open() == Paths{"Mo-Fr menu/a"});
}

TEST_CASE("without a clock only what is shown at any time is shown") {
    House house;
    house.set_files({"2020-01-01.. a", "b"});
    CHECK(house.hours.advance(std::nullopt));
    CHECK(house.open() == Paths{"b"});
    CHECK(house.hours.advance(at(1, 0s)));
    CHECK(house.open() == Paths{"2020-01-01.. a", "b"});
    // a clock that runs ahead is followed, and comes back
    CHECK_FALSE(house.hours.advance(at(1, 0s) + std::chrono::years(50)));
    house.set_files({"2026-12-01..2026-12-24 a", "b"});
    CHECK(house.hours.advance(at(1, 0s) + std::chrono::years(50)));
    CHECK(house.open() == Paths{"b"});
    CHECK(house.hours.advance(at(2, 0s)));
    CHECK(house.open().size() == 2);
}

TEST_CASE("what folders say counts as soon as it is known, and is handed on") {
    House house;
    house.set_files({"a/x", "b/3x y"});
    CHECK(house.hours.advance(at(1, 12h)));
    house.hours.set_folders({{"a", hints_in_name("18-20 5s", NamePart::folder)}});
    CHECK(house.hours.advance(at(1, 12h)));
    CHECK(house.open() == Paths{"b/3x y"});
    CHECK(house.hours.hints().find("b/3x y")->hints.repeat == 3);
    house.hours.set_folders({});
    CHECK(house.hours.advance(at(1, 12h)));
    CHECK(house.open().size() == 2);
}

TEST_CASE("where nothing has a time the choice stays as it is") {
    House house;
    house.set_files({"20s a"});
    CHECK(house.hours.advance(std::nullopt));
    CHECK_FALSE(house.hours.has_hours());
    CHECK_FALSE(house.hours.advance(at(1, 0s)));
}
