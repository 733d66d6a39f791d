#include "player/scene/files/shot_rotation.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

bool always(const ShotKey& /*key*/) {
    return true;
}

bool holds_none(const ShotKey& /*key*/) {
    return false;
}

void set(ShotRotation& round, const std::vector<MediaRecord>& records) {
    round.set_files(records);
}

std::vector<ShotKey> take_all(ShotRotation& round) {
    std::vector<ShotKey> keys;
    while (const auto key = round.next_shot(always))
        keys.push_back(*key);
    return keys;
}

}  // namespace

TEST_CASE("by name, shots come by path and in time order") {
    ShotRotation round(ShotOrder::name, 1);
    set(round, {photo("b"), film("a", 2), photo("c")});
    // the first shots of new files come before the later ones
    CHECK(take_all(round) == std::vector<ShotKey>{{"a", 0}, {"b", 0}, {"c", 0}, {"a", 1}});
    round.restart_finished(holds_none);
    CHECK(take_all(round) == std::vector<ShotKey>{{"a", 0}, {"a", 1}, {"b", 0}, {"c", 0}});
}

TEST_CASE("by newest, the file changed last comes first") {
    ShotRotation round(ShotOrder::newest, 1);
    set(round, {photo("a", 5), photo("b", 9), photo("c", 7)});
    CHECK(take_all(round) == std::vector<ShotKey>{{"b", 0}, {"c", 0}, {"a", 0}});
}

TEST_CASE("by the time taken, the earliest comes first, whatever the file's own time") {
    ShotRotation round(ShotOrder::taken, 1);
    const auto taken = [](MediaRecord record, std::chrono::hours at) {
        record.origin.taken = TimeTaken{.at = std::chrono::sys_days(std::chrono::year(2023) / 5 / 1) + at};
        return record;
    };
    MediaRecord by_own_time = photo("d");  // the file's own time counts where no other is known
    by_own_time.mtime_ns =
        std::chrono::nanoseconds(std::chrono::sys_days(std::chrono::year(2023) / 5 / 1).time_since_epoch())
            .count();
    set(round, {taken(photo("a", 5), 9h), taken(photo("b", 9), 1h), taken(photo("c", 7), 2h), by_own_time});
    CHECK(take_all(round) == std::vector<ShotKey>{{"d", 0}, {"b", 0}, {"c", 0}, {"a", 0}});
}

TEST_CASE("what was taken on this day in other years comes first in each round") {
    const auto taken = [](MediaRecord record, std::chrono::local_days date) {
        record.origin.taken = TimeTaken{.at = std::chrono::sys_days(date.time_since_epoch()) + 23h,
                                        .zone = -60min,
                                        .source = TimeSource::camera};
        return record;
    };
    const auto date = [](int year, unsigned month, unsigned day) {
        return std::chrono::local_days(std::chrono::year(year) / std::chrono::month(month) /
                                       std::chrono::day(day));
    };
    ShotRotation round(ShotOrder::name, 1);
    ShowHints hints;
    hints.today = date(2026, 11, 23);
    MediaRecord by_own_time = taken(photo("e"), date(2020, 11, 23));
    by_own_time.origin.taken->source = TimeSource::file;
    const std::vector<MediaRecord> records{photo("a"),
                                           taken(photo("b"), date(2026, 11, 23)),
                                           taken(photo("c"), date(2025, 11, 23)),
                                           taken(photo("d"), date(2019, 11, 23)),
                                           by_own_time,
                                           taken(photo("f"), date(2024, 2, 29))};
    round.set_files(records, hints);
    const auto two = [&] { return std::vector<ShotKey>{*round.next_shot(always), *round.next_shot(always)}; };
    CHECK(two() == std::vector<ShotKey>{{"c", 0}, {"d", 0}});
    take_all(round);
    round.restart_all(holds_none);
    CHECK(two() == std::vector<ShotKey>{{"c", 0}, {"d", 0}});
    hints.today = date(2027, 2, 28);
    round.set_files(records, hints);
    CHECK(round.next_shot(always) == ShotKey{"f", 0});
}

TEST_CASE("shuffled, every shot comes once and those of one film in time order") {
    ShotRotation round(ShotOrder::shuffle, 3);
    set(round, {film("a", 20), film("b", 20), photo("c")});
    take_all(round);
    round.restart_finished(holds_none);
    const std::vector<ShotKey> keys = take_all(round);
    CHECK(keys.size() == 41);
    int next_a = 0;
    int next_b = 0;
    int changes = 0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i].path == "a") CHECK(keys[i].shot == next_a++);
        if (keys[i].path == "b") CHECK(keys[i].shot == next_b++);
        if (i > 0 && keys[i].path != keys[i - 1].path) ++changes;
    }
    CHECK(changes > 10);
}

TEST_CASE("the same seed gives the same order and another seed another") {
    const auto order = [](std::uint64_t seed) {
        ShotRotation round(ShotOrder::shuffle, seed);
        set(round, {film("a", 20), film("b", 20)});
        return take_all(round);
    };
    CHECK(order(1) == order(1));
    CHECK(order(1) != order(2));
}

TEST_CASE("a new file is next and a file that is gone has no turn") {
    ShotRotation round(ShotOrder::name, 1);
    set(round, {photo("a"), photo("b"), photo("c")});
    set(round, {photo("a"), photo("c"), photo("d")});
    CHECK(take_all(round) == std::vector<ShotKey>{{"d", 0}, {"a", 0}, {"c", 0}});
}

TEST_CASE("only files of which all was shown begin again, those on the wall last") {
    ShotRotation round(ShotOrder::name, 1);
    set(round, {photo("a"), photo("b"), film("f", 2)});
    for (int i = 0; i < 3; ++i)
        round.next_shot(always);  // a, b, f 0
    round.restart_finished([](const ShotKey& key) { return key.path == "a"; });
    CHECK(take_all(round) == std::vector<ShotKey>{{"f", 1}, {"b", 0}, {"a", 0}});
}

TEST_CASE("what comes three times as often has three turns in a round, evenly spread") {
    ShotRotation round(ShotOrder::name, 1);
    const std::vector<MediaRecord> records{photo("a"), photo("b"), photo("c"), photo("d")};
    round.set_files(records, {{"a", {.repeat = 3}}});
    CHECK(take_all(round).size() == 6);
    round.restart_all(holds_none);
    CHECK(take_all(round) ==
          std::vector<ShotKey>{{"a", 0}, {"b", 0}, {"a", 0}, {"c", 0}, {"a", 0}, {"d", 0}});
    round.restart_finished(holds_none);
    CHECK(take_all(round).size() == 6);
}

TEST_CASE("a film that comes twice in a round comes as a whole each time") {
    ShotRotation round(ShotOrder::shuffle, 5);
    const MediaRecord twice = film("a", 4);
    round.set_files(std::vector{twice}, {{"a", {.repeat = 2}}});
    take_all(round);
    round.restart_all(holds_none);
    CHECK(
        take_all(round) ==
        std::vector<ShotKey>{{"a", 0}, {"a", 1}, {"a", 2}, {"a", 3}, {"a", 0}, {"a", 1}, {"a", 2}, {"a", 3}});
}

TEST_CASE("turns that are left are not given anew") {
    ShotRotation round(ShotOrder::name, 1);
    const MediaRecord often = photo("a");
    round.set_files(std::vector{often}, {{"a", {.repeat = 3}}});
    for (int i = 0; i < 5; ++i)
        round.restart_all(holds_none);
    CHECK(take_all(round).size() == 3);
}
