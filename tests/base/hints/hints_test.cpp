#include "base/hints/hints.hpp"

#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

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

TEST_CASE("weekdays hold from midnight to midnight, and a night is of the day on which it begins") {
    const Hints work = folder("Mo-Fr menu");
    CHECK_FALSE(is_open(work, at(2026, 5, 3, 23h + 59min)));  // a Sunday
    CHECK(is_open(work, at(2026, 5, 4, 0s)));
    CHECK(is_open(work, at(2026, 5, 8, 23h + 59min + 59s)));
    CHECK_FALSE(is_open(work, at(2026, 5, 9, 0s)));
    const Hints night = folder("Sat 22-04 club");
    CHECK_FALSE(is_open(night, at(2026, 5, 9, 3h)));
    CHECK(is_open(night, at(2026, 5, 9, 23h)));
    CHECK(is_open(night, at(2026, 5, 10, 3h)));
    CHECK_FALSE(is_open(night, at(2026, 5, 10, 23h)));
    CHECK_FALSE(is_open(work, std::nullopt));
}

TEST_CASE("a holiday counts as a Sunday") {
    const Holidays holidays{std::chrono::local_days(std::chrono::year(2026) / 12 / 25)};  // a Friday
    CHECK_FALSE(is_open(folder("Mo-Fr menu"), at(2026, 12, 25, 12h), holidays));
    CHECK(is_open(folder("Sa-So brunch"), at(2026, 12, 25, 12h), holidays));
    CHECK(is_open(folder("Mo-Fr menu"), at(2026, 12, 24, 12h), holidays));
    CHECK(is_open(folder("08-18 menu"), at(2026, 12, 25, 12h), holidays));
}

namespace {

struct Opening {
    std::chrono::local_seconds begin;
    std::chrono::local_seconds end;
};

/// All openings of `days` days, written down one after the other.
std::vector<Opening> openings(const Hints& hints, const Holidays& holidays, std::chrono::local_days first,
                              int days) {
    std::vector<Opening> list;
    for (int i = 0; i < days; ++i) {
        const std::chrono::local_days day = first + std::chrono::days(i);
        const unsigned iso = holidays.contains(day) ? 7 : std::chrono::weekday(day).iso_encoding();
        if (hints.weekdays && (hints.weekdays->days & (1U << (iso - 1))) == 0) continue;
        if (hints.period && hints.period->first && day < *hints.period->first) continue;
        if (hints.period && hints.period->last && day > *hints.period->last) continue;
        if (!hints.hours) {
            list.push_back({day, day + std::chrono::days(1)});
            continue;
        }
        const bool is_next_day = hints.hours->to <= hints.hours->from;
        list.push_back(
            {day + hints.hours->from, day + hints.hours->to + std::chrono::days(is_next_day ? 1 : 0)});
    }
    return list;
}

}  // namespace

TEST_CASE("1,000 generated calendars are open when their openings, written down day by day, say so") {
    std::mt19937 random(21);
    const auto chance = [&](int of) { return std::uniform_int_distribution<int>(0, of - 1)(random); };
    const std::chrono::local_days first = std::chrono::local_days(std::chrono::year(2026) / 12 / 1);
    int open = 0;
    for (int calendar = 0; calendar < 1000; ++calendar) {
        CAPTURE(calendar);
        Hints hints;
        if (chance(3) > 0) hints.weekdays = Weekdays{static_cast<std::uint8_t>(1 + chance(127))};
        if (chance(3) > 0) {
            const int from = chance(24 * 60);
            hints.hours = Hours{std::chrono::minutes(from),
                                std::chrono::minutes((from + 1 + chance(24 * 60 - 1)) % (24 * 60))};
        }
        if (chance(3) == 0)
            hints.period = Period{.first = first + std::chrono::days(chance(20)),
                                  .last = first + std::chrono::days(20 + chance(20))};
        Holidays holidays;
        for (int i = chance(4); i > 0; --i)
            holidays.insert(first + std::chrono::days(chance(40)));
        const std::vector<Opening> reference = openings(hints, holidays, first - std::chrono::days(2), 44);
        for (int look = 0; look < 100; ++look) {
            const std::chrono::local_seconds now = first + std::chrono::minutes(chance(40 * 24 * 60));
            const bool is_expected = std::ranges::any_of(
                reference, [&](const Opening& one) { return now >= one.begin && now < one.end; });
            const bool is_scheduled = hints.weekdays || hints.hours || hints.period;
            CHECK(is_open(hints, now, holidays) == (is_expected || !is_scheduled));
            open += is_expected ? 1 : 0;
        }
    }
    CHECK(open > 20'000);
    CHECK(open < 80'000);
}

TEST_CASE("the inner hint counts, each kind by itself") {
    CHECK(merged(folder("08-18 20s"), folder("10-12 3x")) == folder("10-12 20s 3x"));
    CHECK(merged(folder("sound"), folder("mute")).sound == false);
}

TEST_CASE("hints are told in words that an operator would use") {
    CHECK(in_words(folder("2026-12-01..2026-12-24 08-18 20s 3x sound")) ==
          "from 2026-12-01 to 2026-12-24, from 08:00 to 18:00, for 20 seconds, 3 times as often, with sound");
    CHECK(in_words(folder("So,Mo-Mi 08-18")) == "on Monday to Wednesday, Sunday, from 08:00 to 18:00");
    CHECK(in_words(folder("..2026-12-24")) == "until 2026-12-24");
    CHECK(in_words(folder("2026-12-24..2026-12-24")) == "on 2026-12-24");
    CHECK(in_words(Hints{}).empty());
}
