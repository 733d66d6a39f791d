#include "analyzer/words/text_page.hpp"

#include <doctest/doctest.h>

namespace vitrine::analyzer {

TEST_CASE("lines that nobody could read on a wall are left out") {
    const std::vector<Box> lines{{{10, 10}, {200, 40}}, {{10, 60}, {200, 64}}, {{10, 80}, {60, 92}}};
    const std::vector<Box> readable = readable_lines(lines, {640, 480});
    REQUIRE(readable.size() == 2);
    CHECK(readable[0] == lines[0]);
    CHECK(readable[1] == lines[2]);
    // A line of 12 px beside one of 200 px is small print.
    const std::vector<Box> poster{{{10, 10}, {600, 210}}, {{10, 300}, {300, 312}}};
    CHECK(readable_lines(poster, {640, 480}).size() == 1);
    // A line that stands upright is as high as it is wide.
    const std::vector<Box> upright{{{10, 10}, {14, 300}}, {{30, 10}, {50, 300}}};
    CHECK(readable_lines(upright, {640, 480}).size() == 1);
}

TEST_CASE("three lines and more that fill a part of the picture are a page") {
    const std::vector<Box> menu{{{100, 60}, {400, 100}}, {{100, 120}, {420, 150}}, {{110, 170}, {380, 200}}};
    const Polygon page = text_page(menu, {640, 360});
    REQUIRE_FALSE(page.empty());
    for (const Box& line : menu) {
        CHECK(is_inside_convex(page, line.min));
        CHECK(is_inside_convex(page, line.max));
    }
    CHECK(text_page(std::vector<Box>(menu.begin(), menu.begin() + 2), {640, 360}).empty());
    CHECK(text_page(menu, {6400, 3600}).empty());
    // Signs here and there in a street are none.
    const std::vector<Box> signs{{{10, 10}, {60, 30}}, {{500, 40}, {560, 60}}, {{300, 330}, {340, 350}}};
    CHECK(text_page(signs, {640, 360}).empty());
}

}  // namespace vitrine::analyzer
