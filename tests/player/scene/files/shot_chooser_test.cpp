#include "player/scene/files/shot_chooser.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

RecordList wall_files(const std::vector<MediaRecord>& records) {
    WallFiles files;
    files.set(records);
    return files.all();
}

ShotChooser chooser_of(const std::vector<MediaRecord>& records, FilmShow film = FilmShow::side_by_side) {
    ShotChooser chooser(ShotOrder::name, 1, film);
    chooser.set_files(wall_files(records), {}, {});
    return chooser;
}

/// A slot of a wall with four slots.
FreeSlot free_slot(std::vector<ShotKey> on_wall, std::string leaving = {}) {
    return {.on_wall = std::move(on_wall), .leaving = std::move(leaving), .slots = 4};
}

}  // namespace

TEST_CASE("a wall has the files whose shots can all be shown") {
    MediaRecord waiting = photo("waiting");
    waiting.state = MediaState::waiting;
    MediaRecord flat = photo("flat");
    flat.height = 0;
    MediaRecord shotless = photo("shotless");
    shotless.shots.clear();
    MediaRecord halted = film("halted", 2);
    halted.shots[1].end = halted.shots[1].begin;

    const RecordList files =
        wall_files(std::vector{photo("a"), waiting, flat, shotless, halted, film("b", 2)});

    CHECK(files.size() == 2);
    CHECK(files.contains("a"));
    CHECK(files.contains("b"));
}

TEST_CASE("a slot stays free when every shot is on the wall") {
    ShotChooser chooser = chooser_of({photo("a"), photo("b")});
    CHECK(chooser.next_shot(free_slot({{"a", 0}})) == ShotKey{"b", 0});
    CHECK_FALSE(chooser.next_shot(free_slot({{"a", 0}, {"b", 0}})));
}

TEST_CASE("other files come before a second shot of a film, and that before a free slot") {
    ShotChooser chooser = chooser_of({film("f", 3), photo("p"), photo("q")});
    CHECK(chooser.next_shot(free_slot({})) == ShotKey{"f", 0});
    CHECK(chooser.next_shot(free_slot({{"f", 0}})) == ShotKey{"p", 0});
    CHECK(chooser.next_shot(free_slot({{"f", 0}, {"p", 0}})) == ShotKey{"q", 0});
    CHECK(chooser.next_shot(free_slot({{"f", 0}, {"p", 0}, {"q", 0}})) == ShotKey{"f", 1});
}

TEST_CASE("a file's only shot gives way to no second shot of a film as long as all files fit on the wall") {
    ShotChooser chooser = chooser_of({film("f", 3), photo("p")});
    chooser.next_shot(free_slot({}));
    chooser.next_shot(free_slot({{"f", 0}}));
    CHECK_FALSE(chooser.next_shot(free_slot({{"f", 0}, {"p", 0}}, "p")));
    CHECK(chooser.next_shot(free_slot({{"f", 0}, {"p", 0}}, "f")) == ShotKey{"f", 1});
}

TEST_CASE("side by side a film's waiting shot comes before a photo repeats; in sequence the photo repeats") {
    const auto next_for_photo = [](FilmShow show) {
        ShotChooser chooser = chooser_of({film("f", 3), photo("p"), photo("q")}, show);
        for (int i = 0; i < 3; ++i)
            chooser.next_shot({.on_wall = {}, .leaving = {}, .slots = 2});
        return chooser.next_shot({.on_wall = {{"f", 0}, {"q", 0}}, .leaving = "q", .slots = 2});
    };
    CHECK(next_for_photo(FilmShow::side_by_side) == ShotKey{"f", 1});
    CHECK(next_for_photo(FilmShow::sequence) == ShotKey{"p", 0});
}

TEST_CASE("an avoided file is not chosen until its time is over") {
    ShotChooser chooser = chooser_of({photo("a"), photo("b")});
    chooser.avoid_file("a", 10s);
    CHECK(chooser.next_shot(free_slot({})) == ShotKey{"b", 0});
    CHECK_FALSE(chooser.next_shot(free_slot({{"b", 0}})));
    CHECK_FALSE(chooser.end_avoidance(9999ms));
    CHECK(chooser.avoided_files() == std::set<std::string>{"a"});
    CHECK(chooser.end_avoidance(10s));
    CHECK_FALSE(chooser.is_avoided("a"));
    CHECK(chooser.next_shot(free_slot({{"b", 0}})) == ShotKey{"a", 0});
}

TEST_CASE("a file is avoided while it grows, and no longer once it is another one or gone") {
    const RecordList two_shots = wall_files(std::vector{film("f", 2)});
    const RecordList three_shots = wall_files(std::vector{film("f", 3)});
    MediaRecord replaced = film("f", 3);
    replaced.mtime_ns = 77;
    const RecordList other = wall_files(std::vector{replaced});
    ShotChooser chooser(ShotOrder::name, 1, FilmShow::side_by_side);
    chooser.set_files(two_shots, {}, {});
    chooser.avoid_file("f", 100s);

    chooser.set_files(three_shots, two_shots, {});
    CHECK(chooser.is_avoided("f"));
    chooser.set_files(other, three_shots, {});
    CHECK_FALSE(chooser.is_avoided("f"));

    chooser.avoid_file("f", 100s);
    chooser.set_files({}, other, {});
    CHECK_FALSE(chooser.is_avoided("f"));
}

TEST_CASE("a pinned file comes before its turn and again, and costs no other file its turn") {
    ShotChooser chooser = chooser_of({photo("a"), photo("b"), photo("c")});
    const std::string pinned = "c";
    FreeSlot slot = free_slot({});
    slot.pinned = &pinned;
    CHECK(chooser.next_shot(slot) == ShotKey{"c", 0});
    CHECK(chooser.next_shot(slot) == ShotKey{"c", 0});
    slot.pinned = nullptr;
    CHECK(chooser.next_shot(slot) == ShotKey{"a", 0});
    CHECK(chooser.next_shot(slot) == ShotKey{"b", 0});
}

TEST_CASE("a pinned file that is not known is like none") {
    ShotChooser chooser = chooser_of({photo("a")});
    const std::string pinned = "gone";
    FreeSlot slot = free_slot({});
    slot.pinned = &pinned;
    CHECK(chooser.next_shot(slot) == ShotKey{"a", 0});
}
