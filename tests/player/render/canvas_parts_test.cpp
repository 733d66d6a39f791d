// The parts of a canvas on several screens are together what one screen would show.

#include "tests/player/render/canvas_parts.hpp"

#include "player/render/renderer.hpp"
#include "tests/player/render/drawn_wall.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("two halves of a canvas are together the whole, in changes and drags") {
    const PartsDifference found = compare_parts(24, 7);
    CHECK(found.frames == 24);
    CHECK(found.channel <= 2);  // the blue of one pixel, by its mixing of neighbours: no grey level
    CHECK(found.odd <= 1);
}

TEST_CASE("a part is drawn in the resolution and the turn of its own screen") {
    const auto egl = std::make_shared<Egl>(Egl::surfaceless());
    DrawnWall drawn(200, 100, {}, egl);
    drawn.add_two();
    const auto shown = [&](int width, int height, const View& view) {
        OffscreenScreen screen({.width = width, .height = height}, egl);
        drawn.renderer.aim(width, height, view);
        screen.begin_frame();
        drawn.renderer.draw(drawn.frame);
        screen.present({});
        return screen.picture();
    };
    const Box middle{{50, 0}, {150, 100}};  // red at its left, blue at its right
    const Picture twice = shown(200, 200, {.part = middle});
    CHECK(is_near(at(twice, 90, 100), red));
    CHECK(is_near(at(twice, 110, 100), blue));
    const Picture turned = shown(50, 50, {.rotation = Rotation::right, .part = middle});
    CHECK(is_near(at(turned, 25, 40), red));  // the canvas' right side is at the top of its pixels
    CHECK(is_near(at(turned, 25, 10), blue));
    const Picture within = shown(100, 60, {.left = 20, .part = middle});
    CHECK(is_near(at(within, 10, 30), {0, 0, 0}));
    CHECK(is_near(at(within, 50, 30), red));
    CHECK(is_near(at(within, 70, 30), blue));
}
