#include "player/layout/canvas.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("a canvas without outputs has no bands") {
    CHECK(canvas_of({100, 50}, {}).bands.empty());
    CHECK(canvas_of({100, 50}, {{{0, 0}, {100, 50}}}).bands.empty());
}

TEST_CASE("the gap between two outputs is a band, and none where they touch") {
    CHECK(canvas_of({210, 50}, {{{0, 0}, {100, 50}}, {{110, 0}, {210, 50}}}).bands ==
          std::vector<Box>{{{100, 0}, {110, 50}}});
    CHECK(canvas_of({200, 50}, {{{0, 0}, {100, 50}}, {{100, 0}, {200, 50}}}).bands.empty());
    CHECK(canvas_of({200.3, 50}, {{{0, 0}, {100, 50}}, {{100.3, 0}, {200.3, 50}}}).bands.empty());
}

TEST_CASE("the bands of a grid of outputs cross") {
    const Canvas canvas = canvas_of(
        {210, 210},
        {{{0, 0}, {100, 100}}, {{110, 0}, {210, 100}}, {{0, 110}, {100, 210}}, {{110, 110}, {210, 210}}});
    CHECK(canvas.bands == std::vector<Box>{{{0, 100}, {210, 110}}, {{100, 0}, {110, 210}}});
}

TEST_CASE("what no output shows beside a smaller one is a band, too") {
    const Canvas canvas = canvas_of({300, 100}, {{{0, 0}, {150, 100}}, {{160, 20}, {300, 80}}});
    CHECK(canvas.bands.size() == 3);
    for (int x = 0; x < 300; x += 3)
        for (int y = 0; y < 100; y += 3) {
            const Vec2 point{x + 0.5, y + 0.5};
            const auto is_in = [&](const std::vector<Box>& boxes) {
                return std::ranges::any_of(boxes, [&](const Box& box) {
                    return point.x > box.min.x && point.x < box.max.x && point.y > box.min.y &&
                           point.y < box.max.y;
                });
            };
            CHECK(is_in(canvas.outputs) != is_in(canvas.bands));
        }
}

TEST_CASE("outputs that touch along an edge are one surface") {
    CHECK(count_surfaces({100, 50}) == 1);
    CHECK(count_surfaces(canvas_of({210, 50}, {{{0, 0}, {100, 50}}, {{110, 0}, {210, 50}}})) == 2);
    CHECK(count_surfaces(canvas_of({200.3, 50}, {{{0, 0}, {100, 50}}, {{100.3, 0}, {200.3, 50}}})) == 1);
    const Box right{{100, 0}, {200, 100}};
    const Box below{{0, 100}, {100, 200}};
    CHECK(count_surfaces(canvas_of({200, 200}, {right, below})) == 2);  // only their corners touch
    CHECK(count_surfaces(canvas_of({200, 200}, {right, below, {{0, 0}, {100, 100}}})) == 1);
    CHECK(count_surfaces(canvas_of({320, 200}, {right, below, {{210, 0}, {320, 200}}})) == 3);
}

TEST_CASE("a canvas with outputs has its outputs where they are on another one, whatever its px") {
    Canvas one = canvas_of({100, 50}, {{{0, 0}, {100, 50}}});
    one.unit = 0.5;
    one.origin = {220, 10};
    Canvas both = canvas_of({420, 120}, {{{0, 20}, {200, 120}}, {{220, 0}, {420, 100}}});
    both.unit = 1;
    both.origin = {0, 10};
    const Placement place = place_on(one, both);
    CHECK(place.scale == 2);
    CHECK(place.offset == Vec2{220, 0});
    CHECK(place_on({100, 50}, {400, 100}).scale == 2);
    CHECK(place_on({100, 50}, {400, 100}).offset == Vec2{100, 0});
}

TEST_CASE("a part of a canvas has its parts of outputs and bands") {
    const Canvas canvas = canvas_of({210, 50}, {{{0, 0}, {100, 50}}, {{110, 0}, {210, 50}}});
    const Canvas part = canvas_within(canvas, {{90, 10}, {120, 40}});
    CHECK(Vec2(part) == Vec2{30, 30});
    CHECK(part.bands == std::vector<Box>{{{10, 0}, {20, 30}}});
    CHECK(part.outputs.size() == 2);
}

TEST_CASE("a point belongs to the output that shows it, or to the nearest") {
    const Canvas canvas = canvas_of({210, 50}, {{{0, 0}, {100, 50}}, {{110, 0}, {210, 50}}});
    CHECK(output_at(canvas, {20, 20}) == canvas.outputs[0]);
    CHECK(output_at(canvas, {104, 20}) == canvas.outputs[0]);
    CHECK(output_at(canvas, {106, 20}) == canvas.outputs[1]);
    CHECK(output_of(canvas, {{80, 0}, {140, 10}}) == canvas.outputs[1]);
    CHECK(output_at(Canvas{300, 100}, {7, 7}) == Box{{0, 0}, {300, 100}});
}

TEST_CASE("a finger needs 15 mm of a panel, and 57 px where it tells no size or nonsense") {
    CHECK(finger_on(1920, 1080, {480, 270}) == doctest::Approx(60));
    CHECK(finger_on(3840, 2160, {1872, 1053}) == doctest::Approx(30.77).epsilon(0.001));
    CHECK(finger_on(1920, 1080, {}) == usual_finger);
    CHECK(finger_on(1920, 1080, {16, 9}) == usual_finger);
    CHECK(finger_on(1920, 1080, {160, 120}) == usual_finger);
}

TEST_CASE("canvases that differ in the size of a finger alone have the same layouts") {
    Canvas fine(1280, 720);
    fine.finger = 200;
    CHECK(fine == Canvas(1280, 720));
}
