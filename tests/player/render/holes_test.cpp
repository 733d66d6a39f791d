// The parts of a wall that no picture reaches: filler, seams and the idle picture.

#include "tests/player/render/drawn_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

constexpr int filler_percent = 30;  // percent of the picture's light

TEST_CASE("filler shows the picture's mirror, darkened") {
    DrawnWall wall;
    wall.add(1, filler(box(100, 0, 200, 100)), {0, 0});
    wall.renderer.upload(1, still(100, 100, [](int x, int) { return x < 50 ? red : green; }).sample);

    const Picture picture = wall.shown();

    const auto dark = [](Colour c) {
        return Colour{c[0] * filler_percent / 100, c[1] * filler_percent / 100, c[2] * filler_percent / 100};
    };
    CHECK(is_near(at(picture, 110, 50), dark(green)));
    CHECK(is_near(at(picture, 190, 50), dark(red)));
}

TEST_CASE("filler is mirrored at a film's bars, and shows nothing of them") {
    DrawnWall wall;
    wall.add(1, filler(box(0, 0, 200, 100)), {0, 0});
    wall.frame.items[0].active = {{0, 15}, {100, 85}};
    wall.renderer.upload(1, still(400, 400, [](int, int y) {
                                return y < 56 || y >= 344 ? Colour{} : Colour{200, 200, 200};
                            }).sample);

    const Picture picture = wall.shown();

    for (int y = 0; y < 100; ++y)
        CHECK(is_near(at(picture, 50, y),
                      {200 * filler_percent / 100, 200 * filler_percent / 100, 200 * filler_percent / 100}));
}

TEST_CASE("filler lets nothing of a photo or a film be recognised") {
    for (const int uploads : {1, 2}) {  // a film's picture is not the first
        DrawnWall wall;
        wall.add(1, filler(box(0, 0, 200, 100)), {0, 0});
        const Still board = still(400, 400, [](int x, int y) {
            return (x / 40 + y / 40) % 2 == 0 ? Colour{0, 0, 0} : Colour{250, 250, 250};
        });
        for (int i = 0; i < uploads; ++i)
            wall.renderer.upload(1, board.sample);

        const Picture picture = wall.shown();

        int darkest = 255;
        int brightest = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 200; ++x) {
                darkest = std::min(darkest, at(picture, x, y)[0]);
                brightest = std::max(brightest, at(picture, x, y)[0]);
            }
        CAPTURE(uploads);
        CAPTURE(darkest);
        CAPTURE(brightest);
        CHECK(brightest - darkest <= 20);  // the board's difference is 250
        CHECK(brightest <= 60);
        CHECK(darkest >= 10);
    }
}

TEST_CASE("no black shows between cells that meet in corners and slanted sides") {
    // Given seven slices round a point off the pixel grid, each side cut in three by a corner of the
    // neighbour.
    DrawnWall wall;
    const Vec2 centre{97.31, 51.77};
    const auto rim = [&](int i) {
        const double angle = i * 2 * 3.14159265358979 / 7;
        return centre + Vec2{std::cos(angle), std::sin(angle)} * 400;
    };
    for (int i = 0; i < 7; ++i) {
        const Vec2 a = rim(i);
        const Vec2 b = rim(i + 1);
        const Vec2 on_side = centre + (a - centre) * 0.123;
        Cell slice{.parts = {{centre, on_side, a, b}}};
        slice.triangles = {{centre, on_side, b}, {on_side, a, b}};
        wall.add(static_cast<SourceId>(i + 1), std::make_shared<const Cell>(slice), {0, 0});
        wall.renderer.upload(static_cast<SourceId>(i + 1), plain({200, 200, 200}).sample);
    }

    const Picture picture = wall.shown();

    int dark = 0;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 200; ++x)
            dark += !is_near(at(picture, x, y), {200, 200, 200});
    CHECK(dark == 0);
}

TEST_CASE("an item without a picture lets the idle picture through, never black") {
    DrawnWall wall;
    wall.add_two();
    wall.renderer.forget(2);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 50, 50), red));
    CHECK_FALSE(wall.renderer.has(2));
    for (const int x : {110, 150, 190}) {
        const Colour c = at(picture, x, 50);
        CHECK(c[0] + c[1] + c[2] > 20);
    }
}

TEST_CASE("the idle picture is nowhere black and moves") {
    DrawnWall wall(320, 180);
    wall.frame = {.canvas = {320, 180}, .idle = 1};

    const Picture first = wall.shown();
    wall.frame.time = 10s;
    const Picture later = wall.shown();

    int darkest = 765;
    int changed = 0;
    for (int y = 0; y < 180; ++y)
        for (int x = 0; x < 320; ++x) {
            const Colour c = at(first, x, y);
            darkest = std::min(darkest, c[0] + c[1] + c[2]);
            changed += !is_near(c, at(later, x, y), 4);
        }
    CHECK(darkest > 20);
    CHECK(changed > 320 * 180 / 10);
}

TEST_CASE("below what items cover whole no idle picture is drawn, and all around it as ever") {
    for (const Rotation rotation : {Rotation::none, Rotation::right, Rotation::half, Rotation::left}) {
        CAPTURE(static_cast<int>(rotation));
        const bool is_upright = rotation == Rotation::none || rotation == Rotation::half;
        const Vec2 canvas = is_upright ? Vec2{200, 100} : Vec2{100, 200};
        DrawnWall wall(207, 111, {.rotation = rotation, .left = 4, .top = 5, .right = 3, .bottom = 6});
        wall.frame = {.canvas = canvas, .idle = 1, .time = 77s};
        wall.add(1, cell(box(10, 20, 90, 60.5)), {10, 20});
        wall.renderer.upload(1, plain(red).sample);
        const Picture expected = wall.shown();
        wall.frame.covered = {{{10, 20}, {90, 60.5}}};
        CHECK(wall.shown().pixels == expected.pixels);

        wall.frame.items.clear();
        wall.add(1, cell(box(10, 70, 90, 90)), {10, 70});
        const Picture elsewhere = wall.shown();
        int black = 0;
        for (int y = 0; y < 111; ++y)
            for (int x = 0; x < 207; ++x)
                black += at(elsewhere, x, y) == Colour{0, 0, 0};
        CHECK(black >= 207 * 111 - 200 * 100 + 80 * 40);
        CHECK(black <= 207 * 111 - 200 * 100 + 80 * 41);
    }
}

TEST_CASE("where an item has no picture yet, the idle picture is drawn below it, covered or not") {
    DrawnWall wall;
    wall.frame.idle = 1;
    wall.add_two();
    wall.frame.covered = {{{0, 0}, {200, 100}}};
    wall.renderer.forget(2);
    const Colour c = at(wall.shown(), 150, 50);
    CHECK(c[0] + c[1] + c[2] > 20);
}
