#include "player/scene/wall_slots.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// Shows at once whatever the slots hold.
struct Shown {
    explicit Shown(int files, int count = 3)
        : slots({.count = count, .order = ShotOrder::name, .dwell = 20s, .lead = 0s}) {
        slots.set_catalogue(photos(files));
        run(100ms);
    }

    void run(std::chrono::nanoseconds duration) {
        for (const auto end = now + duration; now < end; now += 100ms) {
            slots.advance(now);
            for (const WallShot& shot : slots.shots())
                slots.shot_appeared(shot.source, now);
        }
    }

    std::set<std::string> paths() const {
        std::set<std::string> paths;
        for (const WallShot& shot : slots.shots())
            paths.insert(shot.key.path);
        return paths;
    }

    /// The number of files that were there before and are not any more.
    std::size_t gone(const std::set<std::string>& before) const {
        const std::set<std::string> after = paths();
        return static_cast<std::size_t>(
            std::ranges::count_if(before, [&](const std::string& path) { return !after.contains(path); }));
    }

    WallSlots slots;
    std::chrono::nanoseconds now = 0s;
};

std::string path_of(int photo) {
    return photos(photo + 1).back().path;
}

}  // namespace

TEST_CASE("a paused wall keeps what it shows, and goes on when it is not paused any more") {
    Shown wall(10);
    const auto before = wall.paths();
    wall.slots.set_controls({.is_paused = true});
    wall.run(300s);
    CHECK(wall.paths() == before);
    wall.slots.set_controls({});
    wall.run(60s);
    CHECK(wall.gone(before) > 0);
}

TEST_CASE("what is deleted leaves a paused wall") {
    Shown wall(3);
    wall.slots.set_controls({.is_paused = true});
    wall.slots.set_catalogue(photos(2));
    wall.run(1s);
    CHECK(wall.paths().size() == 2);
}

TEST_CASE("a turn that is asked for is taken at once, once, also while the wall is paused") {
    for (const bool is_paused : {false, true}) {
        Shown wall(10);
        const auto before = wall.paths();
        wall.slots.set_controls({.is_paused = is_paused, .turns = 1});
        wall.run(2s);
        CHECK(wall.gone(before) == 1);
    }
}

TEST_CASE("a turn that is asked for where all there is is on the wall changes nothing and is over") {
    Shown wall(3);
    wall.slots.set_controls({.turns = 1});
    wall.run(2s);
    const auto before = wall.paths();
    CHECK(before.size() == 3);
    wall.slots.set_catalogue(photos(10));
    wall.run(1s);
    CHECK(wall.paths() == before);
}

TEST_CASE("a pinned slot keeps its shot while the others change") {
    Shown wall(10);
    const std::string kept = wall.slots.shots()[1].key.path;
    wall.slots.set_controls({.slots = {1}});
    for (int i = 0; i < 20; ++i) {
        wall.run(20s);
        REQUIRE(wall.slots.shots()[1].key.path == kept);
    }
}

TEST_CASE("a file that is pinned comes onto the wall and stays, whether it was shown before or not") {
    for (const int photo : {0, 9}) {
        Shown wall(10);
        wall.run(65s);  // the first three have had their turn
        wall.slots.set_controls({.is_paused = true, .files = {path_of(photo)}});
        wall.run(5s);
        REQUIRE(wall.paths().contains(path_of(photo)));
        wall.slots.set_controls({.files = {path_of(photo)}});
        for (int i = 0; i < 20; ++i) {
            wall.run(20s);
            REQUIRE(wall.paths().contains(path_of(photo)));
        }
    }
}

TEST_CASE("a wall whose every slot is pinned stands, whatever else is asked for") {
    Shown wall(10);
    const auto before = wall.paths();
    wall.slots.set_controls({.turns = 5, .files = {path_of(9)}, .slots = {0, 1, 2}});
    wall.run(100s);
    CHECK(wall.paths() == before);
}
