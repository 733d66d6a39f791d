#include "player/scene/repeated_shots.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

WallShot shot_in(int slot, SourceId source, const std::string& path, const std::string& folder = "") {
    WallShot shot{.source = source, .slot = slot, .key = {path, 0}};
    shot.folder = folder;
    return shot;
}

RepeatedShots repeated_from(SourceId last) {
    return RepeatedShots(std::make_shared<SourceId>(last));
}

std::set<SourceId> sources_of(const std::vector<WallShot>& shots) {
    std::set<SourceId> sources;
    for (const WallShot& shot : shots)
        sources.insert(shot.source);
    return sources;
}

}  // namespace

TEST_CASE("one shot on three displays has two copies, each with a slot and a source of its own") {
    RepeatedShots repeated = repeated_from(7);
    const std::vector<WallShot> shots = repeated.with_copies({shot_in(1, 7, "a")}, 3);
    REQUIRE(shots.size() == 3);
    CHECK(sources_of(shots) == std::set<SourceId>{7, 8, 9});
    CHECK(shots[0].slot == 1);
    CHECK(shots[1].slot == 0);
    CHECK(shots[2].slot == 2);
    for (const WallShot& shot : shots)
        CHECK(shot.key.path == "a");
    CHECK(repeated.original_of(9) == 7);
    CHECK(repeated.original_of(7) == 7);
    CHECK(repeated.original_of(3) == 3);
    CHECK(repeated.with_copies({shot_in(1, 7, "a")}, 3) == shots);  // they keep their sources
}

TEST_CASE("shots are repeated in turn, and no more often than there are displays") {
    RepeatedShots repeated = repeated_from(2);
    const std::vector<WallShot> two{shot_in(0, 1, "a"), shot_in(1, 2, "b")};
    const std::vector<WallShot> shots = repeated.with_copies(two, 5);
    REQUIRE(shots.size() == 5);
    CHECK(shots[2].key.path == "a");
    CHECK(shots[3].key.path == "b");
    CHECK(shots[4].key.path == "a");
    CHECK(shots[4].slot == 4);
    CHECK(repeated.with_copies(two, 2) == two);
    CHECK(repeated.with_copies(two, 1) == two);
    CHECK(repeated.with_copies({}, 3).empty());
}

TEST_CASE("a shot that comes takes the place of a copy, and the other copies keep their sources") {
    RepeatedShots repeated = repeated_from(1);
    const std::vector<WallShot> before = repeated.with_copies({shot_in(0, 1, "a")}, 3);
    const std::vector<WallShot> after = repeated.with_copies({shot_in(0, 1, "a"), shot_in(1, 9, "b")}, 3);
    REQUIRE(after.size() == 3);
    CHECK(after[2].source == before[1].source);
    CHECK(after[1].slot == before[1].slot);
    CHECK(repeated.original_of(before[2].source) == before[2].source);  // it is over
}

TEST_CASE("a copy is hidden for a while, as long as another one is seen") {
    RepeatedShots repeated = repeated_from(1);
    const std::vector<WallShot> one{shot_in(0, 1, "a")};
    const std::vector<WallShot> shots = repeated.with_copies(one, 2);
    CHECK(repeated.hide(1, 60s));
    CHECK(repeated.with_copies(one, 2) == std::vector{shots[1]});
    CHECK_FALSE(repeated.hide(shots[1].source, 61s));
    CHECK(repeated.with_copies(one, 1) == one);  // the other display is gone
    CHECK(repeated.with_copies(one, 2).size() == 1);
    repeated.advance(60s);
    CHECK(repeated.with_copies(one, 2).size() == 2);
    CHECK_FALSE(repeated_from(1).hide(1, 60s));
}

TEST_CASE("the shots of a folder are repeated together and count as one") {
    RepeatedShots repeated = repeated_from(2);
    const std::vector<WallShot> shots =
        repeated.with_copies({shot_in(0, 1, "F/a", "F"), shot_in(0, 2, "F/b", "F")}, 2);
    REQUIRE(shots.size() == 4);
    CHECK(shots[2].key.path == "F/a");
    CHECK(shots[3].key.path == "F/b");
    CHECK(shots[2].slot == 1);
    CHECK(shots[3].slot == 1);
    CHECK(sources_of(shots).size() == 4);
}
