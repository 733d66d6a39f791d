#include "player/display/display_kinds.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace vitrine;
using namespace vitrine::player;

namespace {

std::unique_ptr<DisplayOpener> opener(const std::string& screen) {
    DisplayRequest request;
    request.output.screen = screen;
    return make_display_opener(request);
}

}  // namespace

TEST_CASE("a display is memory of some sizes, or panels, at a card where one is named") {
    CHECK(opener("offscreen:640x360+64x36")->traits().expected == ScreenSize{640, 360});
    CHECK(opener("kms")->traits().has_terminal);
    CHECK(opener("kms:/dev/dri/card1")->traits().is_awaited);
}

TEST_CASE("only a display that nobody looks at waits for its pictures") {
    CHECK(opener("offscreen:64x36")->traits().can_wait_for_pictures);
    CHECK_FALSE(opener("kms")->traits().can_wait_for_pictures);
}

TEST_CASE("a display that is not understood is refused with what is allowed") {
    for (const char* text :
         {"", "x11", "offscreen", "offscreen:", "offscreen:1280", "offscreen:1280x", "offscreen:0x720",
          "offscreen:-1x720", "offscreen:1280x720x2", "offscreen:99999x720", "offscreen:64x32+",
          "offscreen:+64x32", "offscreen:64x32+kms", "kms:", "kms:card1"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(opener(text), std::invalid_argument);
    }
}
