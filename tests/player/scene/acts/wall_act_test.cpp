#include "player/scene/acts/wall_act.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("each point of the canvas has one box: the one that shows it, or hangs nearest") {
    const std::map<std::string, ActPart> parts{{"a/1", {.box = {{0, 0}, {100, 100}}}},
                                               {"b/1", {.box = {{120, 0}, {220, 100}}}},
                                               {"b/2", {.box = {{0, 120}, {100, 220}}}},
                                               {"c/1", {}}};
    const auto boxes_of = [&](Vec2 point) {
        std::string boxes;
        for (const char* const box : {"a", "b", "c", "d"})
            if (has_point(box, parts, point)) boxes += box;
        return boxes;
    };
    CHECK(boxes_of({50, 50}) == "acd");  // c and d have no output there: they show all
    CHECK(boxes_of({150, 50}) == "bcd");
    CHECK(boxes_of({108, 50}) == "acd");
    CHECK(boxes_of({110, 50}) == "acd");
    CHECK(boxes_of({50, 112}) == "bcd");
    CHECK(boxes_of({-500, 50}) == "acd");
    CHECK(has_point("a", {}, {50, 50}));
}
