#include "player/scene/folders/folder_names.hpp"

#include "tests/player/scene/folders/folder_house.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

const Polygon rhombus{{320, 60}, {480, 180}, {320, 300}, {160, 180}};  // beside which there is room

}  // namespace

TEST_CASE("a folder's name stands in its cells, on no I-Region, and is the folder's") {
    std::vector<MediaRecord> records{photo("x")};
    add_files(records, "trips/01_The sea", 4);
    add_files(records, "trips/the hills", 4);
    add_files(records, "20s home", 7);
    for (MediaRecord& record : records)
        record.shots[0].region.polygon = rhombus;
    FolderHouse house(records);
    house.run(4s);
    REQUIRE(house.last.frame.names.size() == 2);
    CHECK(house.last.frame.names[0].text == "home");
    CHECK(house.last.frame.names[1].text == "trips");
    for (const FrameName& name : house.last.frame.names) {
        CHECK(name.box.height() >= 0.026 * 720);
        for (const DrawItem& item : house.last.frame.items) {
            const Polygon region = transformed(rhombus, item.placement.scale, item.placement.offset);
            CHECK(area(clipped(region, name.box)) == doctest::Approx(0));
        }
        for (const Vec2 corner : to_polygon(name.box)) {
            const auto seen = house.wall->shot_at(corner + (name.box.centre() - corner) * 0.01);
            REQUIRE(seen);
            CHECK(seen->key.path.find(name.text) != std::string::npos);
        }
    }
    REQUIRE(house.tap("trips"));
    house.run(4s);
    REQUIRE(house.last.frame.names.size() == 2);
    CHECK(house.last.frame.names[0].text == "The sea");
}

TEST_CASE("a wall without folders has no names") {
    const std::vector<PlacedShot> nothing;
    CHECK(folder_names(nothing, {1280, 720}, {}).empty());
}
