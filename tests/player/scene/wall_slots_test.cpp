#include "player/scene/wall_slots.hpp"

#include "tests/player/scene/scene_media.hpp"
#include "tests/tries.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <random>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// Shows at once whatever the slots hold, and counts how often each shot came.
struct Player {
    WallSlots slots;  // slots that do not look ahead, so that turns come at their time
    std::chrono::nanoseconds now = 0s;
    std::map<SourceId, ShotKey> seen{};
    std::map<ShotKey, int> times{};
    std::vector<ShotKey> order{};

    void look() {
        for (const WallShot& shot : slots.shots()) {
            slots.shot_appeared(shot.source, now);
            if (!seen.emplace(shot.source, shot.key).second) continue;
            ++times[shot.key];
            order.push_back(shot.key);
        }
    }

    void run(std::chrono::nanoseconds duration) {
        for (const auto end = now + duration; now < end; now += 100ms) {
            slots.advance(now);
            look();
        }
    }

    std::multiset<std::string> paths() const {
        std::multiset<std::string> paths;
        for (const WallShot& shot : slots.shots())
            paths.insert(shot.key.path);
        return paths;
    }
};

Player make_player(SlotSettings settings, const std::vector<MediaRecord>& records,
                   const ShowHints& hints = {}) {
    settings.lead = 0s;
    Player player{.slots = WallSlots(settings)};
    player.slots.set_catalogue(records, hints);
    player.look();
    return player;
}

}  // namespace

TEST_CASE("every photo is shown once before any is shown again") {
    for (const ShotOrder order : {ShotOrder::shuffle, ShotOrder::name, ShotOrder::newest}) {
        for (int seed = 1; seed <= tries(2, 5); ++seed) {
            Player wall = make_player({.count = 4, .order = order, .seed = static_cast<std::uint64_t>(seed)},
                                      photos(13));
            for (int i = 0; i < 200; ++i) {
                wall.run(5s);
                int smallest = 1000;
                int largest = 0;
                for (const MediaRecord& record : photos(13)) {
                    smallest = std::min(smallest, wall.times[{record.path, 0}]);
                    largest = std::max(largest, wall.times[{record.path, 0}]);
                }
                REQUIRE(largest - smallest <= 1);
            }
            CHECK(wall.order.size() > 100);
        }
    }
}

TEST_CASE("photos of this day in other years come onto the wall before all others, in any order of shots") {
    using namespace std::chrono;
    ShowHints hints;
    hints.today = local_days(2026y / November / 23);
    for (const ShotOrder order : {ShotOrder::shuffle, ShotOrder::name, ShotOrder::taken}) {
        for (unsigned seed = 1; seed <= 3; ++seed) {
            std::mt19937 random(seed);
            std::vector<MediaRecord> records = photos(400);
            std::set<std::string> matches;
            for (MediaRecord& record : records) {
                const year in(2015 + static_cast<int>(random() % 11));
                const year_month_day date =
                    in / November / std::chrono::day(static_cast<unsigned>(1 + random() % 28));
                record.origin.taken =
                    TimeTaken{.at = sys_days(date) + 12h, .zone = 0min, .source = TimeSource::camera};
                if (date.day() == 23d) matches.insert(record.path);
            }
            Player wall = make_player({.count = 5, .order = order, .seed = seed}, records, hints);
            while (wall.order.size() < matches.size())
                wall.run(1s);
            std::set<std::string> first;
            for (std::size_t i = 0; i < matches.size(); ++i)
                first.insert(wall.order[i].path);
            REQUIRE(matches.size() > 5);
            CHECK(first == matches);
        }
    }
}

TEST_CASE("the same seed shows the same and another seed another") {
    const auto shown = [](std::uint64_t seed) {
        Player wall = make_player({.count = 3, .seed = seed}, photos(20));
        wall.run(300s);
        return wall.order;
    };
    CHECK(shown(7) == shown(7));
    CHECK(shown(7) != shown(8));
}

TEST_CASE("a shot stays for its time, then one slot at a time changes") {
    Player wall = make_player({.count = 3, .dwell = 20s, .spacing = 3s}, photos(10));
    wall.run(19900ms);
    CHECK(wall.order.size() == 3);
    wall.run(1s);
    CHECK(wall.order.size() == 4);
    wall.run(2s);
    CHECK(wall.order.size() == 4);
    wall.run(1s);
    CHECK(wall.order.size() == 5);
}

TEST_CASE("time counts only once a shot is shown") {
    WallSlots slots({.count = 1, .dwell = 20s, .lead = 0s});
    slots.set_catalogue(photos(2));
    const SourceId first = slots.shots()[0].source;
    slots.advance(100s);
    CHECK(slots.shots()[0].source == first);
    slots.shot_appeared(first, 100s);
    slots.advance(119s);
    CHECK(slots.shots()[0].source == first);
    slots.advance(120s);
    CHECK(slots.shots()[0].source != first);
}

TEST_CASE("a film leaves at the end of a loop, a very long one in its midst") {
    const auto first_stay = [](std::chrono::nanoseconds shot) {
        Player wall =
            make_player({.count = 1, .film = FilmShow::side_by_side, .dwell = 20s, .max_dwell = 60s},
                        {film("f", 2, shot)});
        while (wall.order.size() < 2)
            wall.run(100ms);
        return std::chrono::round<std::chrono::seconds>(wall.now - 100ms);
    };
    CHECK(first_stay(7s) == 21s);
    CHECK(first_stay(20s) == 20s);
    CHECK(first_stay(45s) == 45s);
    CHECK(first_stay(300s) == 60s);
}

TEST_CASE("fewer items than slots are fewer on the wall, and they stay") {
    Player wall = make_player({.count = 6}, photos(2));
    wall.run(300s);
    CHECK(wall.order.size() == 2);
    CHECK(make_player({.count = 6}, {}).slots.shots().empty());
}

TEST_CASE("a single film fills the slots with its shots side by side, each once before any again") {
    Player wall = make_player({.count = 4}, {film("f", 11)});
    CHECK(wall.order == std::vector<ShotKey>{{"f", 0}, {"f", 1}, {"f", 2}, {"f", 3}});
    for (int i = 0; i < 100; ++i) {
        wall.run(3s);
        int smallest = 1000;
        int largest = 0;
        for (int shot = 0; shot < 11; ++shot) {
            smallest = std::min(smallest, wall.times[{"f", shot}]);
            largest = std::max(largest, wall.times[{"f", shot}]);
        }
        REQUIRE(largest - smallest <= 1);
    }
}

TEST_CASE("the next shot is chosen before the last has had its time, and says when it is due") {
    WallSlots slots({.count = 2, .dwell = 20s, .lead = 4s});
    slots.set_catalogue(photos(4));
    CHECK_FALSE(slots.due());
    const std::vector<WallShot> first = slots.shots();
    for (const WallShot& shot : first)
        slots.shot_appeared(shot.source, 10s);
    slots.advance(25900ms);
    CHECK(slots.shots() == first);
    slots.advance(26s);
    CHECK(slots.shots() != first);
    CHECK(slots.due() == 30s);
    const std::vector<WallShot> second = slots.shots();
    slots.advance(28900ms);
    CHECK(slots.shots() == second);
    slots.set_catalogue(photos(1));
    CHECK_FALSE(slots.due());  // a shot whose file is gone leaves at once
}

TEST_CASE("a film that others keep waiting leaves at the end of a loop, where that is soon") {
    const auto second_due = [](std::chrono::nanoseconds loop) {
        std::vector<MediaRecord> records{film("a", 1, loop), film("b", 1, loop), film("c", 1, loop),
                                         film("d", 1, loop)};
        WallSlots slots({.count = 2, .dwell = 20s, .spacing = 3s, .lead = 4s});
        slots.set_catalogue(records);
        for (const WallShot& shot : slots.shots())
            slots.shot_appeared(shot.source, 0s);
        slots.advance(16s);
        CHECK(slots.due() == 20s);
        slots.advance(19s);
        return slots.due();
    };
    CHECK(second_due(4s) == 24s);
    CHECK(second_due(10s) == 23s);  // 30 s would hold up the others
}

TEST_CASE("a shot that the store gets is the same shot, with its clip") {
    WallSlots slots({.count = 1});
    slots.set_catalogue(std::vector{film("a", 1)});
    const SourceId source = slots.shots()[0].source;
    MediaRecord grown = film("a", 1);
    grown.shots[0].stored = {.file = "clip", .width = 320, .height = 180};
    slots.set_catalogue(std::vector{grown});
    CHECK(slots.shots()[0].source == source);
    CHECK(slots.shots()[0].shot.stored == grown.shots[0].stored);
}

TEST_CASE("every shot of every file is shown once before any is shown again, where files take turns") {
    std::vector<MediaRecord> records = photos(8);
    records.push_back(film("f", 30));
    records.push_back(film("g", 50));
    Player wall = make_player({.count = 4}, records);
    while (wall.order.size() < 88 && wall.now < 3600s)
        wall.run(1s);
    CHECK(wall.times.size() == 88);
}

namespace {

struct Files {
    std::vector<MediaRecord> records;
    int shots = 0;
};

Files random_files(std::mt19937_64& engine) {
    Files files;
    const auto count = 1 + engine() % 9;
    for (std::size_t i = 0; i < count; ++i) {
        const int shots = engine() % 2 == 0 ? 0 : 1 + static_cast<int>(engine() % 7);
        const std::string name = "f" + std::to_string(engine() % 1000) + "-" + std::to_string(i);
        files.records.push_back(shots == 0 ? photo(name, static_cast<std::int64_t>(engine() % 5))
                                           : film(name, shots, std::chrono::seconds(1 + engine() % 30)));
        files.shots += std::max(1, shots);
    }
    return files;
}

/// Counts the visits of each shot to the wall.
class Rounds {
  public:
    explicit Rounds(const std::vector<MediaRecord>& records) {
        for (const MediaRecord& record : records)
            for (int shot = 0; shot < static_cast<int>(record.shots.size()); ++shot)
                times_[{record.path, shot}] = 0;
    }

    void change(const std::set<ShotKey>& now) {
        std::vector<ShotKey> left;
        std::set_difference(stood_.begin(), stood_.end(), now.begin(), now.end(), std::back_inserter(left));
        for (const ShotKey& key : left)
            times_[key] = std::max(times_[key], round_);  // it stood while the others came
        for (const ShotKey& key : now) {
            if (stood_.contains(key)) continue;
            const bool is_own_place = std::any_of(
                left.begin(), left.end(), [&](const ShotKey& other) { return other.path == key.path; });
            if (!is_own_place) check(key);
            ++times_[key];
            if (!is_own_place) round_ = std::max(round_, times_[key]);
        }
        stood_ = now;
    }

  private:
    /// No shot comes again while another one waits that has not come at all, or is a whole round behind.
    void check(const ShotKey& key) const {
        const int before = times_.at(key);
        for (const auto& [other, times] : times_)
            REQUIRE((stood_.contains(other) || before == 0 ||
                     times >= std::max(1, std::min(round_, before) - 1)));
    }

    std::map<ShotKey, int> times_;
    std::set<ShotKey> stood_;
    int round_ = 0;
};

}  // namespace

TEST_CASE(
    "over hundreds of random catalogues no shot comes again while another waits, and none stands twice") {
    std::mt19937_64 engine(11);
    for (int k = 0; k < tries(200, 500); ++k) {
        const Files files = random_files(engine);
        const int slots = 1 + static_cast<int>(engine() % 6);
        Player wall = make_player(
            {.count = slots, .order = static_cast<ShotOrder>(engine() % 3), .seed = engine(), .dwell = 5s},
            files.records);
        REQUIRE(static_cast<int>(wall.slots.shots().size()) == std::min(slots, files.shots));
        Rounds rounds(files.records);
        for (int i = 0; i < 60; ++i, wall.now += 1s) {
            wall.slots.advance(wall.now);
            wall.look();
            std::set<ShotKey> stand;
            for (const WallShot& shot : wall.slots.shots())
                REQUIRE(stand.insert(shot.key).second);
            rounds.change(stand);
        }
    }
}

TEST_CASE("over hundreds of random changes new files come before all that was there") {
    std::mt19937_64 engine(12);
    for (int k = 0; k < tries(200, 400); ++k) {
        Files files = random_files(engine);
        Player wall = make_player(
            {.count = 1 + static_cast<int>(engine() % 4), .seed = engine(), .dwell = 5s}, files.records);
        wall.run(std::chrono::seconds(engine() % 60));
        const std::size_t shown = wall.order.size();
        std::set<std::string> added;
        for (std::size_t i = 0; i <= engine() % 3; ++i) {
            files.records.push_back(photo("new" + std::to_string(i)));
            added.insert(files.records.back().path);
        }
        wall.slots.set_catalogue(files.records);
        wall.look();
        wall.run(30s);
        CHECK(wall.order.size() > shown);
        for (std::size_t i = shown; i < std::min(shown + added.size(), wall.order.size()); ++i)
            REQUIRE(added.contains(wall.order[i].path));
    }
}

TEST_CASE("in sequence, a film alone shows each shot once through, evenly staggered and in time order") {
    Player wall = make_player({.count = 4, .film = FilmShow::sequence}, {film("f", 40, 16s)});
    std::vector<std::chrono::nanoseconds> changes;
    for (std::size_t count = wall.order.size(); wall.now < 120s;) {
        wall.run(100ms);
        if (wall.order.size() == count) continue;
        count = wall.order.size();
        changes.push_back(wall.now);
    }
    REQUIRE(changes.size() > 20);
    for (std::size_t i = 1; i < changes.size(); ++i) {
        CHECK(changes[i] - changes[i - 1] >= 3900ms);
        CHECK(changes[i] - changes[i - 1] <= 4300ms);
    }
    for (int shot = 0; shot < 24; ++shot)
        CHECK(wall.order[static_cast<std::size_t>(shot)] == ShotKey{"f", shot});
}

TEST_CASE(
    "a film alone plays in sequence by default and its first shot leaves within 3 s; two films do not") {
    Player alone = make_player({.count = 4}, {film("f", 12, 30s)});
    alone.run(3s);
    REQUIRE(alone.order.size() == 5);
    CHECK(alone.order.back() == ShotKey{"f", 4});
    alone.run(57s);
    CHECK(alone.order.size() >= 10);
    Player two = make_player({.count = 4}, {film("f", 12, 30s), film("g", 12, 30s)});
    two.run(29s);
    CHECK(two.order.size() == 4);
}

TEST_CASE("a shot shorter than a second gives way as soon as another may come") {
    MediaRecord record = film("f", 8, 5s);
    record.shots[1].end = record.shots[1].begin + 600ms;
    Player wall =
        make_player({.count = 4, .order = ShotOrder::name, .film = FilmShow::side_by_side}, {record});
    wall.run(1s);
    const std::vector<WallShot> shots = wall.slots.shots();
    CHECK(std::ranges::none_of(shots, [](const WallShot& shot) { return shot.key.shot == 1; }));
}

TEST_CASE("in sequence, a film stands on the wall once while other files are there") {
    std::vector<MediaRecord> records = photos(8);
    records.push_back(film("f", 30));
    records.push_back(film("g", 50));
    Player wall = make_player({.count = 4, .film = FilmShow::sequence}, records);
    for (int i = 0; i < 400; ++i) {
        wall.run(3s);
        const auto paths = wall.paths();
        REQUIRE(std::set(paths.begin(), paths.end()).size() == 4);
    }
    for (int shot = 0; shot < 30; ++shot)
        CHECK(wall.times[{"f", shot}] >= 1);
    for (const MediaRecord& record : photos(8))
        CHECK(wall.times[{record.path, 0}] >= 2);
}

TEST_CASE("the shots of a film take the places that no other file wants and never a photo's only one") {
    std::vector<MediaRecord> records = photos(2);
    records.push_back(film("f", 9));
    Player wall = make_player({.count = 5}, records);
    for (int i = 0; i < 100; ++i) {
        wall.run(3s);
        const auto paths = wall.paths();
        REQUIRE(paths.count("f") == 3);
        REQUIRE(paths.size() == 5);
    }
    for (int shot = 0; shot < 9; ++shot)
        CHECK(wall.times[{"f", shot}] >= 2);
}

TEST_CASE("a new file takes a free slot at once and is next where there is none") {
    Player wall = make_player({.count = 3}, photos(2));
    std::vector<MediaRecord> records = photos(3);
    wall.slots.set_catalogue(records);
    CHECK(wall.paths().count("p102") == 1);
    wall.look();
    records.push_back(photo("a"));
    records.push_back(photo("z"));
    wall.slots.set_catalogue(records);
    CHECK(wall.paths().size() == 3);
    wall.run(30s);
    const std::set<std::string> next{wall.order[3].path, wall.order[4].path};
    CHECK(next == std::set<std::string>{"a", "z"});
}

TEST_CASE("a deleted file leaves at once and another takes its place") {
    Player wall = make_player({.count = 3, .order = ShotOrder::name}, photos(5));
    std::vector<MediaRecord> records = photos(5);
    records.erase(records.begin() + 1);
    wall.slots.set_catalogue(records);
    CHECK(wall.paths() == std::multiset<std::string>{"p100", "p102", "p103"});
    CHECK(wall.slots.shots()[1].key.path == "p103");
    wall.run(300s);
    CHECK(wall.times[{"p101", 0}] == 1);
    wall.slots.set_catalogue({});
    CHECK(wall.slots.shots().empty());
}

TEST_CASE("a file that is not ready any more leaves as a deleted one does") {
    Player wall = make_player({.count = 2}, photos(2));
    std::vector<MediaRecord> records = photos(2);
    records[0].state = MediaState::waiting;
    wall.slots.set_catalogue(records);
    CHECK(wall.paths() == std::multiset<std::string>{"p101"});
}

TEST_CASE("a replaced file is loaded anew in its slot and the others stay") {
    Player wall = make_player({.count = 2, .order = ShotOrder::name}, photos(2));
    const auto before = wall.slots.shots();
    std::vector<MediaRecord> records = photos(2);
    wall.slots.set_catalogue(records);
    CHECK(wall.slots.shots() == before);
    records[0].mtime_ns = 77;
    wall.slots.set_catalogue(records);
    const auto after = wall.slots.shots();
    CHECK(after[0].key == before[0].key);
    CHECK(after[0].source != before[0].source);
    CHECK(after[1] == before[1]);
}

TEST_CASE("a film to which shots are added plays on, and its new shots come to the wall") {
    std::vector<MediaRecord> records = photos(1);
    records[0].shots.push_back(records[0].shots[0]);
    records[0].is_complete = false;
    std::vector<MediaRecord> first = records;
    first[0].shots.pop_back();
    Player wall = make_player({.count = 2, .order = ShotOrder::name}, first);
    const auto before = wall.slots.shots();
    REQUIRE(before.size() == 1);
    wall.slots.set_catalogue(records);
    const auto after = wall.slots.shots();
    REQUIRE(after.size() == 2);
    CHECK(after[0] == before[0]);
    records[0].is_complete = true;
    wall.slots.set_catalogue(records);
    CHECK(wall.slots.shots() == after);
}

TEST_CASE("a file that failed gives way and is tried again later or when it changes") {
    Player wall = make_player({.count = 1, .order = ShotOrder::name, .retry_after = 60s}, photos(1));
    const SourceId first = wall.slots.shots()[0].source;
    wall.slots.source_failed(first, 0s);
    CHECK(wall.slots.shots().empty());
    wall.run(59s);
    CHECK(wall.slots.shots().empty());
    wall.run(2s);
    CHECK(wall.slots.shots().size() == 1);
    wall.slots.source_failed(wall.slots.shots()[0].source, wall.now);
    wall.slots.set_catalogue(photos(1));
    CHECK(wall.slots.shots().empty());
    std::vector<MediaRecord> changed = photos(1);
    changed[0].bytes = 5;
    wall.slots.set_catalogue(changed);
    CHECK(wall.slots.shots().size() == 1);
}

TEST_CASE("no source is ever named twice") {
    Player wall = make_player({.count = 2}, photos(3));
    wall.run(300s);
    CHECK(wall.seen.size() == wall.order.size());
    CHECK(wall.seen.rbegin()->first == wall.seen.size());
}

TEST_CASE("a shot stays for as long as its name says, a film too") {
    SlotSettings settings{.count = 1, .order = ShotOrder::name, .dwell = 20s, .lead = 0s};
    Player wall{.slots = WallSlots(settings)};
    wall.slots.set_catalogue(std::vector{photo("5s a"), film("b", 1, 10s), photo("c")},
                             {{"5s a", {.dwell = 5s}}, {"b", {.dwell = 7s}}});
    wall.look();
    wall.run(4900ms);
    CHECK(wall.order.size() == 1);
    wall.run(300ms);
    CHECK(wall.order.size() == 2);
    wall.run(6800ms);
    CHECK(wall.order.size() == 2);
    wall.run(300ms);
    CHECK(wall.order == std::vector<ShotKey>{{"5s a", 0}, {"b", 0}, {"c", 0}});
}

TEST_CASE("what comes three times as often is on the wall three times as often") {
    for (const ShotOrder order : {ShotOrder::shuffle, ShotOrder::name}) {
        SlotSettings settings{.count = 2, .order = order, .lead = 0s};
        Player wall{.slots = WallSlots(settings)};
        wall.slots.set_catalogue(photos(10), {{"p103", {.repeat = 3}}});
        wall.look();
        wall.run(std::chrono::hours(tries(4, 12)));
        int others = 0;
        for (const auto& [key, times] : wall.times)
            others += key.path == "p103" ? 0 : times;
        const double share = wall.times[{"p103", 0}] / (others / 9.0);
        CHECK(share > 2.8);
        CHECK(share < 3.2);
    }
}
