#include "player/scene/pan/panning_shots.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

std::vector<ShotKey> next_keys(PanningShots& shots, std::size_t count, const std::vector<ShotKey>& wall) {
    std::vector<ShotKey> keys;
    for (const WallShot& shot : shots.next_shots(
             count, [&](const ShotKey& key) { return std::ranges::find(wall, key) != wall.end(); }))
        keys.push_back(shot.key);
    return keys;
}

using Keys = std::vector<ShotKey>;

}  // namespace

TEST_CASE("the shots of a panning wall take turns, and none comes that is on the wall") {
    PanningShots shots(ShotOrder::name, 1, 0);
    shots.set_files(photos(4), {});
    CHECK(next_keys(shots, 3, {}) == Keys{{"p100", 0}, {"p101", 0}, {"p102", 0}});
    // the round begins again behind the last photo; the two on the wall are left out
    CHECK(next_keys(shots, 2, {{"p101", 0}, {"p102", 0}}) == Keys{{"p103", 0}, {"p100", 0}});

    PanningShots others(ShotOrder::name, 1, 0);
    others.set_files(photos(4), {});
    CHECK(next_keys(others, 2, {{"p100", 0}}) == Keys{{"p101", 0}, {"p102", 0}});
}

TEST_CASE("with too few files a shot comes twice, each time as a source of its own") {
    PanningShots shots(ShotOrder::name, 1, 40);
    shots.set_files(photos(2), {});
    const std::vector<WallShot> next = shots.next_shots(5, [](const ShotKey&) { return false; });
    REQUIRE(next.size() == 5);
    CHECK(next[0].key != next[1].key);
    CHECK(std::ranges::count(next, ShotKey{"p100", 0}, &WallShot::key) >= 2);
    CHECK(std::ranges::count(next, ShotKey{"p101", 0}, &WallShot::key) >= 2);
    for (std::size_t i = 0; i < next.size(); ++i)
        CHECK(next[i].source == 41 + i);
    CHECK(shots.next_shots(1, [](const ShotKey&) { return true; }).front().source == 46);
}

TEST_CASE("without files there are no shots") {
    PanningShots shots(ShotOrder::name, 1, 0);
    CHECK(shots.is_empty());
    CHECK(next_keys(shots, 3, {}).empty());
    shots.set_files(photos(1), {});
    CHECK_FALSE(shots.is_empty());
    shots.set_files(RecordList(), {});
    CHECK(shots.is_empty());
    CHECK(next_keys(shots, 3, {}).empty());
}

TEST_CASE("a file that is gone or not ready has no turn") {
    MediaRecord failed = photo("c");
    failed.state = MediaState::failed;
    PanningShots shots(ShotOrder::name, 1, 0);
    shots.set_files(std::vector{photo("a"), photo("b"), failed}, {});
    CHECK_FALSE(shots.has_file("c"));
    shots.set_files(std::vector{photo("b"), failed}, {});
    CHECK_FALSE(shots.has_file("a"));
    CHECK(next_keys(shots, 1, {}) == Keys{{"b", 0}});
    CHECK(next_keys(shots, 1, {}) == Keys{{"b", 0}});
}

TEST_CASE("a file that comes more often has more turns in a round") {
    PanningShots shots(ShotOrder::name, 1, 0);
    shots.set_files(std::vector{photo("a"), photo("b")}, {{"a", {.repeat = 3}}});
    Keys one_by_one;
    for (int i = 0; i < 8; ++i)
        one_by_one.push_back(next_keys(shots, 1, {}).front());
    CHECK(std::ranges::count(one_by_one, std::string("a"), &ShotKey::path) == 6);
}

TEST_CASE("a shot on a panning wall has the data of its record") {
    PanningShots shots(ShotOrder::name, 1, 0);
    shots.set_files(std::vector{film("f", 2, 5s)}, {});
    const std::vector<WallShot> next = shots.next_shots(2, [](const ShotKey&) { return false; });
    REQUIRE(next.size() == 2);
    CHECK(next[1].key == ShotKey{"f", 1});
    CHECK(next[1].kind == MediaKind::film);
    CHECK(next[1].picture == Vec2{640, 360});
    CHECK(next[1].shot.begin == 5s);
    CHECK(next[1].item.region == middle().polygon);
}
