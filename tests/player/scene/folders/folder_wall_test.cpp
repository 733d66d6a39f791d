#include "player/scene/folders/folder_wall.hpp"

#include "base/geometry/polygon.hpp"
#include "player/scene/folders/back_mark.hpp"
#include "player/scene/wall_cells.hpp"
#include "tests/player/scene/folders/folder_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// Three folders, one with two sub-folders, and two loose files.
std::vector<MediaRecord> three_folders() {
    std::vector<MediaRecord> records{photo("x"), photo("y")};
    add_files(records, "a/left", 4);
    add_files(records, "a/right", 3);
    add_files(records, "b", 7);
    add_files(records, "c", 2);
    return records;
}

/// The places of all items of a frame; moving photos do not occur.
std::vector<std::pair<SourceId, Placement>> places(const Frame& frame) {
    std::vector<std::pair<SourceId, Placement>> all;
    for (const DrawItem& item : frame.items)
        all.emplace_back(item.source, item.placement);
    return all;
}

std::set<std::string> standing_paths(const FolderHouse& house) {
    std::set<std::string> paths;
    for (const SlotShot& shot : house.wall->standing())
        paths.insert(shot.key.path);
    return paths;
}

/// True if items cover every sampled place of the canvas.
bool covers_all(const Frame& frame) {
    for (int y = 0; y < 18; ++y)
        for (int x = 0; x < 32; ++x) {
            const Vec2 point{(x + 0.5) * frame.canvas.x / 32, (y + 0.5) * frame.canvas.y / 18};
            const bool is_covered = std::ranges::any_of(frame.items, [&](const DrawItem& item) {
                PlacedShot placed;
                placed.cell = item.cell;
                return item.alpha > 0.9 && is_at(placed, point);
            });
            if (!is_covered) return false;
        }
    return true;
}

}  // namespace

TEST_CASE("the wall holds an entry a slot: folders with several shots beside loose files") {
    FolderHouse house(three_folders());
    house.run(3s);
    std::map<std::string, int> shots;
    for (const SlotShot& shot : house.wall->standing())
        ++shots[shot.key.path.substr(0, shot.key.path.find('/'))];
    CHECK(shots == std::map<std::string, int>{{"a", 5}, {"b", 5}, {"c", 2}, {"x", 1}, {"y", 1}});
    CHECK(house.wall->opened_folder().empty());
}

TEST_CASE("a tap opens a folder, and going back leaves every place as it was") {
    FolderHouse house(three_folders());
    house.run(3s);
    const auto before = places(house.last.frame);
    REQUIRE(house.tap("a"));
    house.run(3s);
    CHECK(house.wall->opened_folder() == "a");
    for (const std::string& path : standing_paths(house))
        CHECK(path.starts_with("a/"));
    REQUIRE(house.tap("a/left"));
    house.run(3s);
    CHECK(house.wall->opened_folder() == "a/left");
    CHECK(standing_paths(house).size() == 4);
    house.go_back();
    house.run(3s);
    CHECK(house.wall->opened_folder() == "a");
    house.go_back();
    house.run(3s);
    CHECK(house.wall->opened_folder().empty());
    CHECK(places(house.last.frame) == before);
    CHECK(house.playing.size() == before.size());
}

TEST_CASE(
    "a wall that is due to turn while a folder is open is the same when the folder closes, and turns then") {
    FolderHouse house(three_folders(), 3);
    house.run(SlotSettings().dwell - 2s);
    const auto before = places(house.last.frame);
    REQUIRE(house.tap("a"));
    house.run(3s);
    REQUIRE(house.wall->opened_folder() == "a");
    house.go_back();
    house.run(1500ms);
    CHECK(places(house.last.frame) == before);
    house.run(3s);
    CHECK(places(house.last.frame) != before);
}

TEST_CASE("while a folder opens and closes nothing is dark and nothing jumps") {
    FolderHouse house(three_folders());
    house.run(3s);
    REQUIRE(house.tap("b"));
    int frames = 0;
    const auto look = [&] {
        CHECK(covers_all(house.last.frame));
        CHECK(house.last.frame.idle == 0);
        ++frames;
    };
    house.run(3s, look);
    house.go_back();
    house.run(3s, look);
    CHECK(frames == 120);
}

TEST_CASE("folders open to a depth of twenty, and a touch on the way back closes each") {
    constexpr int depth = 20;
    std::vector<MediaRecord> records;
    std::string folder;
    for (int k = 0; k < depth; ++k) {
        records.push_back(photo(folder + "a"));
        records.push_back(photo(folder + "b"));
        folder += "f" + std::to_string(k) + "/";
    }
    records.push_back(photo(folder + "a"));
    records.push_back(photo(folder + "b"));
    FolderHouse house(records, 4);
    house.run(3s);
    std::vector<std::vector<std::pair<SourceId, Placement>>> walls;
    std::string path;
    for (int k = 0; k < depth; ++k) {
        walls.push_back(places(house.last.frame));
        path += (k > 0 ? "/f" : "f") + std::to_string(k);
        REQUIRE(house.tap(path));
        house.run(2s);
        REQUIRE(house.wall->opened_folder() == path);
        CHECK(house.playing.size() <= 3 * 8);
    }
    int differing = 0;
    for (int k = depth; k-- > 0;) {
        house.tap_at(house.wall->way_back().centre());
        house.run(2s);
        for (const auto& place : walls[static_cast<std::size_t>(k)])
            differing += std::ranges::count(places(house.last.frame), place) == 0 ? 1 : 0;
    }
    CHECK(house.wall->opened_folder().empty());
    CHECK(differing == 0);
}

TEST_CASE("a folder closes by itself when nobody touches for a while, from any depth") {
    FolderHouse house(three_folders());
    house.run(3s);
    REQUIRE(house.tap("a"));
    house.run(3s);
    REQUIRE(house.tap("a/right"));
    house.run(28s);
    CHECK(house.wall->opened_folder() == "a/right");
    house.run(6s);
    CHECK(house.wall->opened_folder().empty());
}

TEST_CASE("a tap on a shot of an opened folder lets it grow, and the folder stays open") {
    FolderHouse house(three_folders());
    house.run(3s);
    REQUIRE(house.tap("b"));
    house.run(3s);
    REQUIRE(house.tap("b/p102"));
    house.run(2s);
    CHECK(house.wall->opened_folder() == "b");
    const auto is_as_large_as_the_screen = [&](const DrawItem& item) {
        return house.playing.at(item.source).path == "b/p102" && item.placement.scale == doctest::Approx(2);
    };
    CHECK(std::ranges::any_of(house.last.frame.items, is_as_large_as_the_screen));
}

TEST_CASE("no I-Region of an opened folder lies under the way back") {
    FolderHouse house(three_folders());
    house.budget = 30'000;
    house.run(3s);
    REQUIRE(house.tap("b"));
    house.run(3s);
    const Box mark = house.wall->way_back();
    int looked_at = 0;
    for (const DrawItem& item : house.last.frame.items) {
        if (item.alpha < 1) continue;
        const Polygon region = transformed(middle().polygon, item.placement.scale, item.placement.offset);
        CHECK(area(clipped(region, mark)) == doctest::Approx(0));
        ++looked_at;
    }
    CHECK(looked_at == 7);
    CHECK(mark.height() >= 57);
}

TEST_CASE(
    "the way back is as high as a finger needs on a fine panel, and the wall is not laid out again for it") {
    FolderHouse house(three_folders());
    house.run(3s);
    const auto before = places(house.last.frame);
    Canvas fine(FolderHouse::canvas());
    fine.finger = 180;
    house.wall->set_canvas(fine);
    house.run(3s);
    CHECK(places(house.last.frame) == before);
    REQUIRE(house.tap("b"));
    house.run(3s);
    CHECK(house.wall->way_back().height() == doctest::Approx(180));
}

TEST_CASE("a file that comes to an opened folder moves the others little, and one that goes closes it only "
          "if it was the last") {
    std::vector<MediaRecord> records = three_folders();
    FolderHouse house(records);
    house.run(3s);
    REQUIRE(house.tap("c"));
    house.run(3s);
    records.push_back(photo("c/p900"));
    house.wall->set_catalogue(records);
    house.run(5s);
    CHECK(standing_paths(house) == std::set<std::string>{"c/p100", "c/p101", "c/p900"});
    std::erase_if(records, [](const MediaRecord& record) { return record.path.starts_with("c/"); });
    house.wall->set_catalogue(records);
    house.run(5s);
    CHECK(house.wall->opened_folder().empty());
    CHECK(standing_paths(house).count("x") == 1);
}

TEST_CASE("every folder of a level comes onto the wall, from two to two hundred") {
    std::mt19937_64 random(11);
    for (const int count : {2, 13, 27, 200}) {
        std::vector<MediaRecord> records;
        for (int i = 0; i < count; ++i)
            add_files(records, "f" + std::to_string(100 + i), 2 + static_cast<int>(random() % 6));
        WallEntries entries({.count = 12, .seed = 3}, true);
        entries.set_catalogue(records);
        std::set<std::string> seen;
        for (auto now = 0s; now < 900s && std::ssize(seen) < count; now += 1s) {
            entries.advance(now);
            for (const WallShot& shot : entries.shots()) {
                entries.shot_appeared(shot.source, now);
                seen.insert(shot.folder);
            }
        }
        CHECK(std::ssize(seen) == count);
    }
}

TEST_CASE("a folder opens on the canvas that the screen has now") {
    FolderHouse house(three_folders());
    house.wall->set_canvas({640, 480});
    house.run(3s);
    REQUIRE(house.tap("b"));
    house.run(3s);
    CHECK(house.wall->opened_folder() == "b");
    CHECK(house.last.frame.canvas == Vec2{640, 480});
}
