#include "player/display/screen_choice.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("screens are memory of some sizes, or panels, at a card where one is named") {
    CHECK(parse_screen("offscreen:1280x720") == ScreenChoice{OffscreenChoice{.screens = {{1280, 720}}}});
    CHECK(parse_screen("offscreen:1280x720+640x360") ==
          ScreenChoice{OffscreenChoice{.screens = {{1280, 720}, {640, 360}}}});
    CHECK(parse_screen("kms") == ScreenChoice{KmsChoice{}});
    CHECK(parse_screen("kms:/dev/dri/card1") == ScreenChoice{KmsChoice{.card = "/dev/dri/card1"}});
}

TEST_CASE("a screen that is not understood is refused with what is allowed") {
    for (const char* text :
         {"", "x11", "offscreen", "offscreen:", "offscreen:1280", "offscreen:1280x", "offscreen:0x720",
          "offscreen:-1x720", "offscreen:1280x720x2", "offscreen:99999x720", "offscreen:64x32+",
          "offscreen:+64x32", "offscreen:64x32+kms", "kms:", "kms:card1"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_screen(text), std::invalid_argument);
    }
}
