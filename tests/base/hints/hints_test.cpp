#include "base/hints/hints.hpp"

#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

std::chrono::local_seconds at(int year, unsigned month, unsigned day, std::chrono::seconds time) {
    return std::chrono::local_days(std::chrono::year(year) / std::chrono::month(month) /
                                   std::chrono::day(day)) +
           time;
}

Hints folder(std::string_view name) {
    return hints_in_name(name, NamePart::folder);
}

}  // namespace

TEST_CASE("what says nothing of time is shown at any time, even at none") {
    CHECK(is_open({}, std::nullopt));
    CHECK(is_open(folder("20s 3x sound"), at(1970, 1, 1, 0s)));
}

TEST_CASE("nothing scheduled is shown while the time is not known") {
    CHECK_FALSE(is_open(folder("00-24"), std::nullopt));
    CHECK_FALSE(is_open(folder("1971-01-01.."), std::nullopt));
}

TEST_CASE("hours begin on the second and end on the second") {
    const Hints day = folder("08-18");
    CHECK_FALSE(is_open(day, at(2026, 5, 4, 7h + 59min + 59s)));
    CHECK(is_open(day, at(2026, 5, 4, 8h)));
    CHECK(is_open(day, at(2026, 5, 4, 17h + 59min + 59s)));
    CHECK_FALSE(is_open(day, at(2026, 5, 4, 18h)));
    CHECK(is_open(folder("18-24"), at(2026, 5, 4, 23h + 59min)));
    CHECK_FALSE(is_open(folder("18-24"), at(2026, 5, 4, 0s)));
}

TEST_CASE("hours over midnight are one stretch") {
    const Hints night = folder("22-06");
    CHECK_FALSE(is_open(night, at(2026, 5, 4, 21h + 59min)));
    CHECK(is_open(night, at(2026, 5, 4, 22h)));
    CHECK(is_open(night, at(2026, 5, 5, 0s)));
    CHECK(is_open(night, at(2026, 5, 5, 5h + 59min)));
    CHECK_FALSE(is_open(night, at(2026, 5, 5, 6h)));
}

TEST_CASE("a period takes both of its days in") {
    const Hints advent = folder("2026-12-01..2026-12-24");
    CHECK_FALSE(is_open(advent, at(2026, 11, 30, 23h + 59min + 59s)));
    CHECK(is_open(advent, at(2026, 12, 1, 0s)));
    CHECK(is_open(advent, at(2026, 12, 24, 23h + 59min + 59s)));
    CHECK_FALSE(is_open(advent, at(2026, 12, 25, 0s)));
    CHECK(is_open(folder("2026-12-01.."), at(2076, 1, 1, 0s)));
    CHECK(is_open(folder("..2026-12-24"), at(1999, 1, 1, 0s)));
}

TEST_CASE("a night belongs to the day on which it begins") {
    const Hints new_year = folder("2026-12-31..2026-12-31 20-04");
    CHECK_FALSE(is_open(new_year, at(2026, 12, 31, 2h)));
    CHECK(is_open(new_year, at(2026, 12, 31, 20h)));
    CHECK(is_open(new_year, at(2027, 1, 1, 3h)));
    CHECK_FALSE(is_open(new_year, at(2027, 1, 1, 20h)));
}

TEST_CASE("the inner hint counts, each kind by itself") {
    CHECK(merged(folder("08-18 20s"), folder("10-12 3x")) == folder("10-12 20s 3x"));
    CHECK(merged(folder("sound"), folder("mute")).sound == false);
}

TEST_CASE("hints are told in words that an operator would use") {
    CHECK(in_words(folder("2026-12-01..2026-12-24 08-18 20s 3x sound")) ==
          "from 2026-12-01 to 2026-12-24, from 08:00 to 18:00, for 20 seconds, 3 times as often, with sound");
    CHECK(in_words(folder("..2026-12-24")) == "until 2026-12-24");
    CHECK(in_words(folder("2026-12-24..2026-12-24")) == "on 2026-12-24");
    CHECK(in_words({}).empty());
}
