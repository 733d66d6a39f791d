// Visitors open folders of a wall over several boxes, and all boxes show the same.

#include "player/layout/plan/plan.hpp"
#include "player/scene/wall_cells.hpp"
#include "tests/player/scene/acts/shared_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

Layout packed(const WallPlan& wanted) {
    Layout layout = plan({.items = wanted.items, .canvas = wanted.canvas, .budget = 2'000, .max_scale = 4});
    layout.generation = wanted.generation;
    layout.is_final = true;
    return layout;
}

/// Two folders, one with a sub-folder, and loose files. The wall turns while a folder is open.
SharedHouse::Options folders(std::uint64_t seed) {
    SharedHouse::Options options{.seed = seed, .followers = 1, .lay_out = packed};
    options.records = {photo("x"), film("y", 2)};
    for (const char* const path : {"a/1", "a/2", "a/3", "a/b/1", "a/b/2", "c/1", "c/2"})
        options.records.push_back(photo(path));
    options.records.push_back(film("a/4", 2));
    options.wall.slots.count = 5;
    options.wall.slots.dwell = 1h;
    options.wall.nests = true;
    return options;
}

LedFolderWall& led(SharedHouse& house) {
    return dynamic_cast<LedFolderWall&>(*house.boxes[0].show);
}

/// A tap on a shot of an entry that is seen.
void tap(SharedHouse& house, const std::string& entry) {
    const TestBox& lead = house.boxes[0];
    for (const DrawItem& item : lead.last.items) {
        const std::string& path = lead.playing.at(item.source).path;
        if (path != entry && !path.starts_with(entry + "/")) continue;
        const Vec2 at = centroid(item.cell->parts.front());
        const std::optional<SeenShot> seen = led(house).shot_at(at);
        if (!seen || seen->source != item.source) continue;
        led(house).handle_gesture(
            {.kind = Gesture::Kind::tap, .touch = 1, .subject = item.source, .at = at, .from = at});
        return;
    }
    FAIL("nothing of '", entry, "' is seen");
}

void go_back(SharedHouse& house) {
    led(house).handle_gesture({.kind = Gesture::Kind::key, .key = Key::back});
}

/// The share of the frames of the last seconds that a follower has shown, too.
double in_step(SharedHouse& house, Ns last) {
    return share_in_step(house.boxes[0], house.boxes[1], house.truth - last);
}

}  // namespace

TEST_CASE("folders are opened into one another and closed on all boxes in step") {
    SharedHouse house(folders(2));
    house.run(8s);
    const TestBox& follower = house.boxes[1];
    const std::size_t wall = follower.last.items.size();
    CHECK_FALSE(follower.last.names.empty());
    CHECK(follower.last.names == house.boxes[0].last.names);
    for (const char* const folder : {"a", "a/b"}) {
        tap(house, folder);
        house.run(5s);
        CHECK(led(house).opened_folder() == folder);
        CHECK(in_step(house, 5s) >= 0.97);
        CHECK(follower.last.plates.size() == 1);  // the way back
        CHECK(follower.last.plates == house.boxes[0].last.plates);
        CHECK(follower.last.names == house.boxes[0].last.names);
    }
    for (const char* const folder : {"a", ""}) {
        go_back(house);
        house.run(5s);
        CHECK(led(house).opened_folder() == folder);
        CHECK(in_step(house, 5s) >= 0.97);
        CHECK(follower.last.plates.size() == (*folder == 0 ? 0 : 1));
    }
    CHECK(follower.last.items.size() == wall);
    CHECK(follower.gaps == 0);
    CHECK(follower.back == 0);
    CHECK(house.faults == 0);
}

TEST_CASE("a folder grows out of its place on all boxes, and the frames of the way are the same") {
    SharedHouse house(folders(3));
    house.run(8s);
    house.boxes[1].slower = 1s;
    tap(house, "a");
    std::size_t on_way = 0;
    std::size_t same = 0;
    for (int k = 0; k < 150; ++k) {
        house.run(33ms);
        const std::optional<FolderStack::Zoom>& zoom = led(house).zoom();
        if (!zoom || !zoom->began) continue;
        ++on_way;
        if (house.boxes[0].frames.back().content == house.boxes[1].frames.back().content) ++same;
    }
    CHECK(on_way >= 20);  // 800 ms
    CHECK(same >= on_way - 4);
}

TEST_CASE("a box that joins while a folder is open shows it with its first picture") {
    SharedHouse::Options options = folders(4);
    options.followers = 2;
    SharedHouse house(options);
    house.run(8s);
    house.kill(2);
    tap(house, "a");
    house.run(5s);
    house.start_follower(2);
    house.boxes[2].frames.clear();
    house.run(6s);
    const ShownFrame* const first = first_picture(house.boxes[2]);
    REQUIRE(first != nullptr);
    CHECK(first->is_whole);
    CHECK(share_in_step(house.boxes[0], house.boxes[2], first->truth) >= 0.99);
    CHECK(house.boxes[2].last.plates == house.boxes[0].last.plates);
}

TEST_CASE("cuts of the network while folders are opened leave no box dark, and all are in step after them") {
    SharedHouse::Options options = folders(5);
    options.cuts = 0.3;
    SharedHouse house(options);
    house.run(8s);
    for (int k = 0; k < 4; ++k) {
        if (led(house).opened_folder().empty())
            tap(house, "a");
        else
            go_back(house);
        house.run(4s);
    }
    CHECK(house.boxes[1].gaps == 0);
    house.heal(1);
    house.run(6s);
    CHECK(house.boxes[1].last.plates == house.boxes[0].last.plates);
    CHECK(in_step(house, 1s) >= 0.9);
}
