#include "player/layout/plan/free_box.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const Polygon triangle{{100, 0}, {200, 0}, {200, 100}};

}  // namespace

TEST_CASE("a box is clear of a polygon beside a slanted side, and not where they come nearer than allowed") {
    CHECK(is_clear_of({{0, 0}, {90, 50}}, triangle, 5));
    CHECK_FALSE(is_clear_of({{0, 0}, {98, 50}}, triangle, 5));
    CHECK(is_clear_of({{100, 60}, {140, 100}}, triangle, 5));
    CHECK_FALSE(is_clear_of({{100, 30}, {140, 100}}, triangle, 5));
    CHECK_FALSE(is_clear_of({{150, 10}, {160, 20}}, triangle, 0));
}

TEST_CASE("a box grows to the field's edges and up to the others") {
    Box box{{10, 10}, {20, 20}};
    const Box field{{0, 0}, {300, 200}};
    const std::vector<Polygon> others{to_polygon({{150, 0}, {160, 200}})};
    for (int k = 0; k < 200 && grow_box(box, field, others, 2, 10); ++k) {
    }
    CHECK(box.min == Vec2{0, 0});
    CHECK(box.max.y == 200);
    CHECK(box.max.x > 146);
    CHECK(box.max.x <= 148);
}
