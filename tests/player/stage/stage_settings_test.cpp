#include "player/stage/stage_settings.hpp"

#include "player/scene/change_pace.hpp"
#include "player/stage/show_modes.hpp"

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

TEST_CASE("a calm wall does not pan, and its turns are as rare as its changes") {
    Settings settings;
    settings.layout.mode = WallMode::pan;
    CHECK(show_mode(settings).mode == WallMode::pan);
    CHECK(slot_settings(settings).spacing < calm_spacing);
    settings.show.calm = true;
    CHECK(show_mode(settings).mode == WallMode::fit);
    CHECK(slot_settings(settings).spacing == calm_spacing);
}

TEST_CASE("a look gives sizes, and a size that is written down wins over it") {
    Settings settings;
    settings.layout.look = WallLook::tiles;
    CHECK(cell_style(settings).gutter > 0);
    CHECK(cell_style(settings).corner_radius > 0);
    CHECK(cell_style(settings).feather == 1);
    settings.layout.look = WallLook::seamless;
    CHECK(cell_style(settings).gutter == 0);
    CHECK(cell_style(settings).feather == 1);
    settings.layout.look = WallLook::soft;
    CHECK(cell_style(settings).gutter == 0);
    CHECK(cell_style(settings).feather > 1);

    settings.layout.gutter = 3;
    settings.layout.corner_radius = 0;
    settings.layout.feather = 1;

    CHECK(cell_style(settings).gutter == 3);
    CHECK(cell_style(settings).corner_radius == 0);
    CHECK(cell_style(settings).feather == 1);
}

TEST_CASE("exact cells have round corners only where a gutter is between them") {
    Settings settings;
    settings.layout.cells = CellMethod::exact;
    CHECK(cell_style(settings).corner_radius == 0);
    settings.layout.look = WallLook::tiles;
    CHECK(cell_style(settings).corner_radius > 0);
}

TEST_CASE("regions keep so far apart that a gutter has room") {
    Settings settings;
    settings.layout.gutter = 12;
    CHECK(plan_request(settings, {640, 360}).clearance == 12);
    settings.layout.clearance = 20;
    CHECK(plan_request(settings, {640, 360}).clearance == 20);
}
