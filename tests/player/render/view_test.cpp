#include "player/render/view.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("a canvas is what the margins leave, turned with the panel") {
    const View margins{.left = 10, .top = 20, .right = 30, .bottom = 40};
    View turned = margins;
    turned.rotation = Rotation::right;

    CHECK(canvas_size(1920, 1080, margins) == Vec2{1880, 1020});
    CHECK(canvas_size(1920, 1080, turned) == Vec2{1020, 1880});
}

TEST_CASE("a canvas of the screen's own shape needs no bars, whatever its size") {
    const View view{};
    CHECK(letterboxed(1920, 1080, view, {1920, 1080}) == view);
    CHECK(letterboxed(640, 360, view, {1920, 1080}) == view);
    CHECK(letterboxed(1280, 720, view, {640, 360}) == view);
}

TEST_CASE("a canvas of another shape lies between two bars") {
    CHECK(letterboxed(1280, 1024, {}, {1920, 1080}) == View{.top = 152, .bottom = 152});
    CHECK(letterboxed(1920, 1080, {}, {1280, 1024}) == View{.left = 285, .right = 285});
}

TEST_CASE("bars come on top of the margins, and lie where the turned panel has them") {
    const View view{.rotation = Rotation::left, .left = 10, .right = 10};

    const View bars = letterboxed(120, 100, view, {100, 50});  // a panel of 100 x 100, turned

    CHECK(bars == View{.rotation = Rotation::left, .left = 35, .right = 35});
}

TEST_CASE("a finger touches the canvas point that is seen below it, however the panel is turned") {
    const Vec2 share{0.3, 0.2};
    for (const Rotation rotation : {Rotation::none, Rotation::right, Rotation::half, Rotation::left}) {
        const View view{.rotation = rotation, .left = 20, .top = 10, .right = 40, .bottom = 30};
        const Vec2 canvas = canvas_size(200, 100, view);
        const Vec2 point = canvas_point(200, 100, view, canvas, share);

        const ToNdc ndc = to_ndc(canvas, rotation);
        const Vec2 seen = ndc.x_axis * point.x + ndc.y_axis * point.y + ndc.origin;
        CHECK(20 + (seen.x + 1) / 2 * 140 == doctest::Approx(share.x * 200));
        CHECK(10 + (1 - seen.y) / 2 * 60 == doctest::Approx(share.y * 100));
    }
}

TEST_CASE("a finger on a screen that shows a part touches the point of that part") {
    for (const Rotation rotation : {Rotation::none, Rotation::right, Rotation::half, Rotation::left}) {
        const View view{.rotation = rotation, .left = 20, .part = Box{{300, 50}, {400, 120}}};
        const Vec2 point = canvas_point(120, 100, view, {500, 500}, {0.3, 0.2});
        const ToNdc ndc = seen_from(to_ndc({100, 70}, rotation), {300, 50});
        const Vec2 seen = ndc.x_axis * point.x + ndc.y_axis * point.y + ndc.origin;
        CHECK(20 + (seen.x + 1) / 2 * 100 == doctest::Approx(0.3 * 120));
        CHECK((1 - seen.y) / 2 == doctest::Approx(0.2));
    }
}

TEST_CASE("a part of another shape than its screen lies between two bars") {
    const View part{.part = Box{{100, 0}, {200, 100}}};
    const View bars = letterboxed(200, 100, part, {1000, 100});
    CHECK(bars.left == 50);
    CHECK(bars.right == 50);
    CHECK(bars.part == part.part);
}

TEST_CASE("a finger on the margin touches the canvas' edge") {
    const View view{.left = 20, .top = 20};
    CHECK(canvas_point(120, 120, view, {50, 50}, {0.1, 0.5}) == Vec2{0, 20});
    CHECK(canvas_point(120, 120, view, {50, 50}, {1, 1}) == Vec2{50, 50});
}
