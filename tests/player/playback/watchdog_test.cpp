#include "player/playback/watchdog.hpp"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Verdict = Watchdog::Verdict;

/// The verdicts on a film that never gives a picture, at 30 a second.
std::vector<std::pair<Verdict, std::chrono::nanoseconds>> verdicts(Watchdog& watchdog,
                                                                   std::chrono::seconds until) {
    std::vector<std::pair<Verdict, std::chrono::nanoseconds>> verdicts;
    for (std::chrono::nanoseconds now = 0s; now < until; now += 33ms) {
        const Verdict verdict = watchdog.judge(true, now);
        if (verdict != Verdict::fine) verdicts.emplace_back(verdict, now);
    }
    return verdicts;
}

}  // namespace

TEST_CASE(
    "a film without a picture is built anew every two seconds, the fourth time in software, then given up") {
    Watchdog watchdog;
    const auto said = verdicts(watchdog, 11s);
    REQUIRE(said.size() == 5);
    for (std::size_t i = 0; i < said.size(); ++i) {
        const auto expected = 2s * static_cast<int>(i + 1);
        CHECK(said[i].second >= expected);
        CHECK(said[i].second < expected + 200ms);
    }
    for (const std::size_t i : {0U, 1U, 2U})
        CHECK(said[i].first == Verdict::rebuild);
    CHECK(said[3].first == Verdict::rebuild_in_software);
    CHECK(said[4].first == Verdict::give_up);
}

TEST_CASE("a film that hesitates for less than two seconds is let alone, however often") {
    Watchdog watchdog;
    for (int i = 0; i < 100; ++i) {
        const std::chrono::nanoseconds now = 3s * i;
        CHECK(watchdog.judge(true, now) == Verdict::fine);
        CHECK(watchdog.judge(true, now + 1900ms) == Verdict::fine);
        CHECK(watchdog.judge(false, now + 2100ms) == Verdict::fine);
    }
}

TEST_CASE("rebuilds are forgiven after a minute without starving, not before") {
    const auto after = [](std::chrono::nanoseconds fine) {
        Watchdog watchdog;
        verdicts(watchdog, 7s);  // three rebuilds
        watchdog.judge(false, 7s);
        watchdog.judge(false, 7s + fine);
        watchdog.judge(true, 8s + fine);
        return watchdog.judge(true, 10s + fine);
    };
    CHECK(after(59s) == Verdict::rebuild_in_software);
    CHECK(after(61s) == Verdict::rebuild);
}
