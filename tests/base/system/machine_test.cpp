#include "base/system/machine.hpp"

#include "base/hints/hint_words.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

/// The time zone of this process while it exists.
class Zone {
  public:
    explicit Zone(const std::string& name) { ::setenv("TZ", name.c_str(), 1); }

    Zone(const Zone&) = delete;
    Zone& operator=(const Zone&) = delete;

    ~Zone() { ::unsetenv("TZ"); }
};

/// Central European time: the system's own table where it has one, and its rules written out.
std::vector<std::string> central_europe() {
    std::vector<std::string> zones{"CET-1CEST,M3.5.0,M10.5.0/3"};
    if (std::filesystem::exists("/usr/share/zoneinfo/Europe/Berlin")) zones.emplace_back("Europe/Berlin");
    return zones;
}

std::chrono::system_clock::time_point utc(unsigned month, unsigned day, std::chrono::seconds time) {
    return std::chrono::sys_days(std::chrono::year(2026) / std::chrono::month(month) /
                                 std::chrono::day(day)) +
           time;
}

std::chrono::local_seconds civil(unsigned month, unsigned day, std::chrono::seconds time) {
    return std::chrono::local_days(std::chrono::year(2026) / std::chrono::month(month) /
                                   std::chrono::day(day)) +
           time;
}

/// Minutes of the UTC day for which these hours are open.
long open_minutes(const char* hours, unsigned month, unsigned day) {
    const Hints hints = hints_in_name(hours, NamePart::folder);
    long open = 0;
    for (auto time = utc(month, day - 1, 12h); time < utc(month, day, 12h); time += 1min)
        open += is_open(hints, local_time(time)) ? 1 : 0;
    return open;
}

}  // namespace

TEST_CASE("where daylight saving begins an hour never comes") {
    for (const std::string& name : central_europe()) {
        const Zone zone(name);
        CHECK(local_time(utc(3, 29, 59min + 59s)) == civil(3, 29, 1h + 59min + 59s));
        CHECK(local_time(utc(3, 29, 1h)) == civil(3, 29, 3h));
        CHECK(open_minutes("02-03", 3, 29) == 0);
        CHECK(open_minutes("02:30-05:00", 3, 29) == 120);
        CHECK(open_minutes("22-06", 3, 29) == 7 * 60);
    }
}

TEST_CASE("where daylight saving ends an hour comes twice") {
    for (const std::string& name : central_europe()) {
        const Zone zone(name);
        CHECK(local_time(utc(10, 25, 30min)) == civil(10, 25, 2h + 30min));
        CHECK(local_time(utc(10, 25, 1h + 30min)) == civil(10, 25, 2h + 30min));
        CHECK(open_minutes("02-03", 10, 25) == 120);
        CHECK(open_minutes("22-06", 10, 25) == 9 * 60);
    }
}

TEST_CASE("another time zone is followed at once, and times long past and to come are known") {
    {
        const Zone zone("UTC");
        CHECK(local_time(utc(7, 1, 12h)) == civil(7, 1, 12h));
        CHECK(local_time({}) == std::chrono::local_seconds(0s));
        CHECK(local_time(utc(7, 1, 0s) + std::chrono::years(50)) == civil(7, 1, 0s) + std::chrono::years(50));
    }
    const Zone zone("EST5");
    CHECK(local_time(utc(7, 1, 12h)) == civil(7, 1, 7h));
}
