#include "player/words/stroke_words.hpp"

#include <doctest/doctest.h>

using namespace vitrine::player;

TEST_CASE("each letter of a name of an output is drawn, one beside the other") {
    const auto strokes = strokes_of("HDMI-A-1");
    double right = 0;
    for (const Stroke& stroke : strokes)
        for (const auto& point : stroke) {
            CHECK(point.x >= 0);
            CHECK(point.y >= 0);
            CHECK(point.y <= 1);
            right = std::max(right, point.x);
        }
    CHECK(right <= stroke_length("HDMI-A-1"));
    CHECK(right > stroke_length("HDMI-A-"));
    CHECK(strokes_of("H").size() == 3);
    CHECK(strokes_of("").empty());
    CHECK(stroke_length("") == 0);
}

TEST_CASE("small letters are drawn as capitals, and what has no strokes as a box") {
    CHECK(strokes_of("dp") == strokes_of("DP"));
    CHECK(strokes_of("?").size() == 4);
    CHECK(strokes_of("\xc3").size() == 4);
    CHECK(strokes_of("E").size() == 4);
}
