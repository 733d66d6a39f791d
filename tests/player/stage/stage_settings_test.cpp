#include "player/stage/stage_settings.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("margins are pixels of the screen, or shares of its own width and height") {
    Settings settings;
    settings.output.margins = "10,2.5%,1%,0";

    CHECK(view_of(settings, 1920, 1080) == View{.left = 10, .top = 27, .right = 19, .bottom = 0});
    CHECK(view_of(settings, 640, 400) == View{.left = 10, .top = 10, .right = 6, .bottom = 0});
}

TEST_CASE("margins that were meant for a larger screen leave a picture on a small one") {
    Settings settings;
    settings.output.margins = "1000";

    const View view = view_of(settings, 640, 360);

    CHECK(canvas_size(640, 360, view) == Vec2{128, 72});
}
