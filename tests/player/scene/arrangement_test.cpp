#include "player/scene/arrangement.hpp"

#include "tests/player/scene/folders/folder_house.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

std::shared_ptr<const ArrangedWall> arranged(const FolderHouse& house) {
    return std::make_shared<const ArrangedWall>(
        ArrangedWall{.canvas = FolderHouse::canvas(), .shots = house.wall->standing()});
}

/// A wall after some time in which shots took turns and a finger has moved one.
FolderHouse used_house(const std::vector<MediaRecord>& records, int slots) {
    FolderHouse house(records, slots, ShotOrder::shuffle);
    house.run(3s);
    house.wall->set_controls({.turns = 3});
    house.run(10s);
    const DrawItem held = house.last.frame.items.front();
    const Vec2 from = centroid(held.cell->parts.front());
    Gesture drag{.kind = Gesture::Kind::drag, .touch = 1, .subject = held.source, .at = from, .from = from};
    for (int k = 0; k < 20; ++k) {
        drag.moved = (FolderHouse::canvas() * 0.5 - from) * 0.05;
        drag.at = drag.at + drag.moved;
        house.wall->handle_gesture(drag);
        house.run(100ms);
    }
    drag.kind = Gesture::Kind::drop;
    house.wall->handle_gesture(drag);
    house.run(3s);
    return house;
}

/// A player that starts with an arrangement.
FolderHouse restarted(const std::vector<MediaRecord>& records, int slots,
                      std::shared_ptr<const ArrangedWall> wall, Vec2 canvas = FolderHouse::canvas()) {
    FolderHouse house({}, slots, ShotOrder::shuffle);
    house.wall->set_controls({.arranged = std::move(wall)});
    house.wall->set_catalogue(records);
    house.wall->set_canvas(canvas);
    house.run(3s);
    return house;
}

std::vector<MediaRecord> without(std::vector<MediaRecord> records, const std::string& path) {
    std::erase_if(records, [&](const MediaRecord& record) { return record.path == path; });
    return records;
}

double moved_share(const SlotShot& a, const SlotShot& b) {
    return length(a.seat.centre - b.seat.centre) / length(FolderHouse::canvas());
}

}  // namespace

TEST_CASE("a wall that is made again has each shot in its slot, at its place and in its size") {
    const std::vector<MediaRecord> records = photos(40);
    const FolderHouse before = used_house(records, 12);
    const FolderHouse after = restarted(records, 12, arranged(before));
    CHECK(after.wall->standing() == before.wall->standing());
    const FolderHouse fresh = restarted(records, 12, nullptr);
    CHECK(fresh.wall->standing() != before.wall->standing());
}

TEST_CASE("folders have the same shots at the same places again") {
    std::vector<MediaRecord> records{photo("x"), photo("y")};
    for (const char* const folder : {"a", "b", "c"})
        add_files(records, folder, 9);
    const FolderHouse before = used_house(records, 4);
    const FolderHouse after = restarted(records, 4, arranged(before));
    CHECK(after.wall->standing() == before.wall->standing());
    CHECK(std::ranges::any_of(after.wall->standing(),
                              [](const SlotShot& shot) { return !shot.folder.empty(); }));
}

TEST_CASE(
    "a file that is gone drops out, another one takes its seat, and the others stay about where they were") {
    const std::vector<MediaRecord> records = photos(40);
    FolderHouse before = used_house(records, 12);
    const std::vector<SlotShot> shots = before.wall->standing();
    FolderHouse after = restarted(without(records, shots[3].key.path), 12, arranged(before));
    const std::vector<SlotShot> again = after.wall->standing();
    REQUIRE(again.size() == shots.size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
        CHECK((again[i].key == shots[i].key) == (i != 3));
        CHECK(moved_share(again[i], shots[i]) < 0.1);
    }
}

TEST_CASE(
    "on a larger canvas of the same shape all places are larger, on one of another shape they are new") {
    const std::vector<MediaRecord> records = photos(40);
    const FolderHouse before = used_house(records, 12);
    const FolderHouse large = restarted(records, 12, arranged(before), FolderHouse::canvas() * 1.5);
    const FolderHouse upright = restarted(records, 12, arranged(before), {720, 1280});
    const std::vector<SlotShot> shots = before.wall->standing();
    for (std::size_t i = 0; i < shots.size(); ++i) {
        CHECK(large.wall->standing()[i].key == shots[i].key);
        CHECK(large.wall->standing()[i].at.scale == doctest::Approx(shots[i].at.scale * 1.5));
        CHECK(upright.wall->standing()[i].key == shots[i].key);
    }
}

TEST_CASE("an arrangement that is loaded brings its shots back, and those on the wall do not begin anew") {
    const std::vector<MediaRecord> records = photos(40);
    FolderHouse house = used_house(records, 12);
    const std::shared_ptr<const ArrangedWall> saved = arranged(house);
    house.wall->set_controls({.turns = 7});
    house.run(4s);
    REQUIRE(house.wall->standing() != saved->shots);
    const std::map<SourceId, ShotRequest> playing = house.playing;
    house.wall->set_controls({.turns = 7, .arranged = saved});
    house.run(4s);
    CHECK(house.wall->standing() == saved->shots);
    const auto stays = [&](const auto& source) { return playing.contains(source.first); };
    CHECK(std::ranges::count_if(house.playing, stays) >= 8);
    house.run(60s);  // it is taken once: turns go on
    CHECK(house.wall->standing() != saved->shots);
}

TEST_CASE("an arrangement that is loaded closes open folders") {
    std::vector<MediaRecord> records{photo("x"), photo("y")};
    add_files(records, "a", 9);
    add_files(records, "b", 9);
    FolderHouse house(records, 4);
    house.run(3s);
    const std::shared_ptr<const ArrangedWall> saved = arranged(house);
    REQUIRE(house.tap("a"));
    house.run(3s);
    REQUIRE(house.wall->opened_folder() == "a");
    house.wall->set_controls({.arranged = saved});
    house.run(4s);
    CHECK(house.wall->opened_folder().empty());
    CHECK(house.wall->standing() == saved->shots);
}

TEST_CASE("a shot whose region has grown is not put over others") {
    std::vector<MediaRecord> records = photos(12);
    FolderHouse before = used_house(records, 12);
    for (MediaRecord& record : records)
        record.shots.front().region.polygon = {{10, 10}, {630, 10}, {630, 350}, {10, 350}};
    const FolderHouse after = restarted(records, 12, arranged(before));
    for (const SlotShot& one : after.wall->standing())
        for (const SlotShot& other : after.wall->standing()) {
            const Polygon large = to_polygon({{10, 10}, {630, 350}});
            const Box box = bounding_box(transformed(large, one.at.scale, one.at.offset));
            const Polygon region = transformed(large, other.at.scale, other.at.offset);
            if (one.key != other.key) CHECK(area(clipped(region, box)) < 1);
        }
}
