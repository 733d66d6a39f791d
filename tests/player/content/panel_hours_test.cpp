#include "player/content/panel_hours.hpp"

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::local_days monday{std::chrono::year(2026) / 11 / 23};

PanelHours hours_of(const char* on, const char* dim = "") {
    return PanelHours(
        {.on = *day_windows_named(on), .dim = *dim_windows_named(dim), .awake = 10min, .holidays = {}});
}

bool is_on(PanelHours& hours, std::chrono::local_seconds local, std::chrono::nanoseconds now = 0s) {
    hours.look(local, now);
    return hours.is_on();
}

}  // namespace

TEST_CASE("panels are on at their hours only, and say once when they change") {
    PanelHours hours = hours_of("Mo-Fr 08:00-18:30");
    CHECK_FALSE(is_on(hours, monday + 8h - 1s));
    CHECK(hours.take_news() == "panels off, outside of output.on");
    CHECK(hours.take_news().empty());
    CHECK(is_on(hours, monday + 8h));
    CHECK(hours.take_news() == "panels on");
    CHECK(is_on(hours, monday + 18h + 30min - 1s));
    CHECK_FALSE(is_on(hours, monday + 18h + 30min));
    CHECK_FALSE(is_on(hours, monday + std::chrono::days(5) + 12h));
}

TEST_CASE("hours over midnight belong to the day on which they start") {
    PanelHours hours = hours_of("Fr 20-02");
    const auto friday = monday + std::chrono::days(4);
    CHECK(is_on(hours, friday + 23h));
    CHECK(is_on(hours, friday + 25h));
    CHECK_FALSE(is_on(hours, friday + 26h));
    CHECK_FALSE(is_on(hours, friday + 1h));
}

TEST_CASE("without hours, and as long as the time is not known, panels are on") {
    PanelHours always = hours_of("");
    CHECK(is_on(always, monday));
    PanelHours hours = hours_of("08-18");
    hours.look(std::nullopt, 0s);
    CHECK(hours.is_on());
}

TEST_CASE("a touch on another box lights the panels as long as it lights that box's") {
    PanelHours hours = hours_of("08-18");
    hours.set_others_awake(true);
    CHECK(is_on(hours, monday, 0s));
    CHECK_FALSE(hours.is_awake(0s));
    hours.set_others_awake(false);
    CHECK_FALSE(is_on(hours, monday, 1s));
    hours.wake(2s);
    CHECK(is_on(hours, monday, 3s));
    CHECK(hours.is_awake(3s));
    CHECK_FALSE(is_on(hours, monday, 2s + 10min));
    CHECK_FALSE(hours.is_awake(2s + 10min));
    PanelHours always = hours_of("");
    always.wake(0s);
    CHECK(is_on(always, monday, 1s));
    CHECK(always.is_awake(1s));  // the other boxes may have hours
}

TEST_CASE("other hours hold from the next look on, and a touch counts as before") {
    PanelHours hours = hours_of("08-18");
    CHECK(is_on(hours, monday + 9h));
    hours.set_rules({.on = *day_windows_named("10-18"), .dim = *dim_windows_named("00-24 50%")});
    CHECK_FALSE(is_on(hours, monday + 9h, 60s));
    CHECK(hours.light() == doctest::Approx(0.5));
    hours.wake(61s);
    hours.set_rules({.on = *day_windows_named("11-18"), .dim = {}});
    CHECK(is_on(hours, monday + 10h, 62s));
}

TEST_CASE("a touch outside the hours turns the panels on for a while") {
    PanelHours hours = hours_of("08-18");
    CHECK_FALSE(is_on(hours, monday, 0s));
    hours.wake(5s);
    CHECK(is_on(hours, monday + 5s, 5s));
    CHECK(is_on(hours, monday + 10min, 10min));
    hours.wake(10min);
    CHECK(is_on(hours, monday + 20min - 1s, 20min - 1s));
    CHECK_FALSE(is_on(hours, monday + 20min, 20min));
}

TEST_CASE("holidays count as Sundays") {
    PanelHours hours(
        {.on = *day_windows_named("Mo-Fr 08-18"), .dim = {}, .awake = 1min, .holidays = {monday}});
    CHECK_FALSE(is_on(hours, monday + 12h));
    CHECK(is_on(hours, monday + 36h));
}

TEST_CASE("the light goes down slowly at its hours and comes back") {
    PanelHours hours = hours_of("", "20:00-06:00 40%");
    hours.look(monday + 12h, 0s);
    CHECK(hours.light() == 1);
    hours.look(monday + 20h, 1s);
    CHECK(hours.light() == doctest::Approx(0.95));
    for (int i = 2; i < 60; ++i)
        hours.look(monday + 20h, std::chrono::seconds(i));
    CHECK(hours.light() == doctest::Approx(0.4));
    PanelHours at_start = hours_of("", "20:00-06:00 40%");
    at_start.look(monday + 21h, 0s);
    CHECK(at_start.light() == doctest::Approx(0.4));
}

TEST_CASE("windows are read as operators write them, and nothing else is") {
    CHECK(day_windows_named("")->empty());
    CHECK(day_windows_named("Mo-Fr 08:00-18:30, Sa,So 10-14")->size() == 2);
    CHECK(day_windows_named("Mo-Fr")->front() ==
          DayWindow{.weekdays = *weekdays_named("Mo-Fr"), .hours = {}});
    for (const char* text : {"8-18", "Mo-Fr 08:00-25:00", "08-08", "Mo-Fr 08-18 x", "always", "08-18 40%"})
        CHECK_FALSE(day_windows_named(text));
    CHECK(dim_windows_named("20:00-06:00 40%, Sun 18-20 60%")->size() == 2);
    for (const char* text : {"20:00-06:00", "20-06 0%", "20-06 101%", "40%", "20-06 x%"})
        CHECK_FALSE(dim_windows_named(text));
}

TEST_CASE("1,000 generated calendars are on when minutes, written down one by one, say so") {
    std::mt19937 engine(1);
    for (int i = 0; i < 1000; ++i) {
        constexpr int minutes_of_week = 7 * 24 * 60;
        std::array<bool, 3 * minutes_of_week> is_lit{};
        std::vector<DayWindow> windows;
        Holidays holidays;
        for (int k = 0; k < 2; ++k)
            holidays.insert(monday + std::chrono::days(engine() % 14));
        for (unsigned k = 0; k <= engine() % 3; ++k) {
            const int from = static_cast<int>(engine() % 96) * 15;
            const int to = static_cast<int>(1 + engine() % 96) * 15;
            if (from == to) continue;
            const Weekdays days{static_cast<std::uint8_t>(1 + engine() % 127)};
            windows.push_back(
                {.weekdays = days,
                 .hours = Hours{.from = std::chrono::minutes(from), .to = std::chrono::minutes(to)}});
            for (int day = 0; day < 15; ++day) {
                const auto date = monday + std::chrono::days(day - 1);
                const int number = holidays.contains(date) ? 6 : (day + 6) % 7;
                if ((days.days >> number & 1) == 0) continue;
                const int length = to > from ? to - from : to - from + 24 * 60;
                for (int minute = 0; minute < length; ++minute)
                    is_lit[static_cast<std::size_t>(day * 24 * 60 + from + minute)] = true;
            }
        }
        if (windows.empty()) continue;
        PanelHours hours({.on = windows, .dim = {}, .awake = 1min, .holidays = holidays});
        bool agrees = true;
        for (int minute = 24 * 60; minute < 14 * 24 * 60; minute += 5) {
            hours.look(monday - std::chrono::days(1) + std::chrono::minutes(minute), 0s);
            agrees = agrees && hours.is_on() == is_lit[static_cast<std::size_t>(minute)];
        }
        CAPTURE(i);
        CHECK(agrees);
    }
}
