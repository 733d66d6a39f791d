#include "player/control/play_ledger.hpp"

#include "base/calendar/dates.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto tick = 40ms;

PlayLedger::Day day_of(std::chrono::local_seconds clock) {
    return std::chrono::floor<std::chrono::days>(clock);
}

/// Reads the times of a day from the files in the folder, the latest notes included.
PlayedTimes told(const fs::path& folder, const std::string& day) {
    PlayedTimes times;
    for (const std::string& name : {day, std::string(played_now)})
        if (fs::exists(folder / name)) merge_played(read_file(folder / name), day, times);
    return times;
}

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

/// A folder as a kill leaves it: what the killed player writes later does not count.
void copy_as_killed(const fs::path& from, const fs::path& to) {
    fs::remove_all(to);
    fs::copy(from, to);
}

}  // namespace

TEST_CASE("each file's time is counted, and the days are those of the wall's clock") {
    const TemporaryDirectory folder;
    const auto day = *date_named("2026-12-24");
    {
        PlayLedger ledger(folder.path);
        const std::chrono::local_seconds midnight = day + 24h;
        for (std::chrono::nanoseconds now{0}; now <= 60s; now += tick) {
            const auto clock = midnight - 20s + std::chrono::floor<std::chrono::seconds>(now);
            ledger.look(now < 30s ? std::set<std::string>{"a", "b"} : std::set<std::string>{"b"}, now,
                        day_of(clock));
        }
    }
    CHECK(seconds(told(folder.path, "2026-12-24")["a"]) == doctest::Approx(20).epsilon(0.01));
    CHECK(seconds(told(folder.path, "2026-12-25")["a"]) == doctest::Approx(10).epsilon(0.01));
    CHECK(seconds(told(folder.path, "2026-12-24")["b"]) == doctest::Approx(20).epsilon(0.01));
    CHECK(seconds(told(folder.path, "2026-12-25")["b"]) == doctest::Approx(40).epsilon(0.01));
}

TEST_CASE("times are right within 1 % over kills and clocks that are set forth and back") {
    std::mt19937 chance(7);
    const TemporaryDirectory kept;
    fs::path folder = kept.path / "0";
    std::chrono::local_seconds clock = *date_named("2026-12-24") + 23h;
    std::map<std::string, std::map<std::string, std::chrono::nanoseconds>> truth;
    std::set<std::string> days;
    for (int run = 1; run <= 12; ++run) {
        PlayLedger ledger(folder);
        const int ticks = 1500 + static_cast<int>(chance() % 6000);
        std::set<std::string> seen;
        std::chrono::nanoseconds into_second{0};
        for (int i = 0; i < ticks; ++i) {
            const std::string day = played_day_name(day_of(clock));
            if (i > 0)
                for (const std::string& path : seen)
                    truth[day][path] += tick;
            if (i % 500 == 0) seen = {std::string(1, static_cast<char>('a' + chance() % 5)), "z"};
            if (chance() % 2000 == 0) clock += std::chrono::hours(static_cast<int>(chance() % 60) - 30);
            ledger.look(seen, i * tick, day_of(clock));
            into_second += tick;
            ledger.finish_writing();  // so that a slow disk of this machine does not count
            clock += std::chrono::floor<std::chrono::seconds>(into_second);
            into_second %= 1s;
        }
        const fs::path next = kept.path / std::to_string(run);
        copy_as_killed(folder, next);
        folder = next;
    }
    { const PlayLedger last(folder); }
    CHECK(truth.size() > 2);
    double sum = 0, difference = 0;
    for (const auto& [day, files] : truth) {
        PlayedTimes times = told(folder, day);
        for (const auto& [path, time] : files) {
            sum += seconds(time);
            difference += std::abs(seconds(times[path] - time));
        }
    }
    MESSAGE("wrong by " << difference << " s of " << sum);
    CHECK(difference < 0.01 * sum);
}

TEST_CASE(
    "a pause of the program counts no more than a moment, and a clock that is not set has a day of its own") {
    const TemporaryDirectory folder;
    {
        PlayLedger ledger(folder.path);
        ledger.look({"a"}, 0s, std::nullopt);
        ledger.look({"a"}, 1s, std::nullopt);
        ledger.look({"a"}, 3600s, std::nullopt);
    }
    CHECK(seconds(told(folder.path, played_undated)["a"]) == doctest::Approx(6));
}

TEST_CASE("damaged lines do not count, and only so many days are kept") {
    const TemporaryDirectory folder;
    const std::string text = played_text("2026-12-24", {{"a", 10s}, {"b", 20s}});
    std::string damaged = text;
    damaged[damaged.find("10000000000")] = '9';
    folder.write("now", damaged);
    for (std::size_t i = 0; i < max_played_days + 5; ++i)
        folder.write(played_day_name(*date_named("2020-01-01") + std::chrono::days(i)), "");
    { const PlayLedger ledger(folder.path); }
    const PlayedTimes times = told(folder.path, "2026-12-24");
    CHECK(!times.contains("a"));
    CHECK(times.at("b") == 20s);
    CHECK(!fs::exists(folder.path / "2020-01-01"));
    CHECK(fs::exists(folder.path / "2020-01-07"));
}
