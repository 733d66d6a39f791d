#include "player/render/uploaded_pictures.hpp"
#include "tests/player/render/drawn_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string_view>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// By how much two pictures of one size differ at most, in a channel of a pixel.
int farthest(const Picture& a, const Picture& b) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        largest = std::max(largest,
                           std::abs(std::to_integer<int>(a.pixels[i]) - std::to_integer<int>(b.pixels[i])));
    return largest;
}

}  // namespace

TEST_CASE("each cell shows its own source") {
    DrawnWall wall;
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 2, 2), red));
    CHECK(is_near(at(picture, 97, 97), red));
    CHECK(is_near(at(picture, 102, 2), blue));
    CHECK(is_near(at(picture, 197, 97), blue));
}

TEST_CASE("a picture stands upright and unmirrored on the wall") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(
        1, still(100, 100, [](int x, int y) { return y < 50 ? (x < 50 ? red : green) : blue; }).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 10, 10), red));
    CHECK(is_near(at(picture, 90, 10), green));
    CHECK(is_near(at(picture, 10, 90), blue));
}

TEST_CASE("blue first is drawn as red first, pixel for pixel, in another size, small and blurred") {
    const auto paint = [](int x, int y) { return y < 150 ? (x < 150 ? red : green) : blue; };
    for (const double scale : {1.0, 0.8, 1.0 / 3}) {
        CAPTURE(scale);
        DrawnWall wall;
        wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
        wall.add(2, filler(box(100, 0, 200, 100)), {100, 0});
        for (DrawItem& item : wall.frame.items)
            item.placement.scale = scale, item.picture = {300, 300};
        Still red_first = still(300, 300, paint);
        for (const SourceId source : {1, 2})
            wall.renderer.upload(source, red_first.sample);
        const Picture expected = wall.shown();
        Still blue_first = still(300, 300, [&](int x, int y) {
            const Colour c = paint(x, y);
            return Colour{c[2], c[1], c[0]};
        });
        blue_first.sample.layout = PixelLayout::bgra;
        for (const SourceId source : {1, 2})
            wall.renderer.upload(source, blue_first.sample);
        CHECK(farthest(wall.shown(), expected) <= 2);
    }
}

TEST_CASE("a cell is drawn whole if one of its three triangles is flat") {
    DrawnWall wall;
    Cell shape = *cell(box(10, 20, 100, 90));
    REQUIRE(shape.triangles.size() == 2);
    shape.triangles.push_back({Vec2{100, 30}, Vec2{100, 30.0001}, Vec2{99.9999, 30.0001}});
    wall.add(1, std::make_shared<const Cell>(shape), {0, 0});
    wall.renderer.upload(1, still(100, 100, [](int, int) { return red; }).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 50, 30), red));
    CHECK(is_near(at(picture, 50, 80), red));
}

TEST_CASE("words lie over the pictures, with their own opacity and the whole's") {
    DrawnWall wall;
    wall.add_two();
    const auto half_white = [] {
        WordPicture words{.width = 8, .height = 4, .rgba = {}};
        for (int pixel = 0; pixel < 32; ++pixel)
            for (const int channel : {255, 255, 255, pixel % 8 < 4 ? 255 : 0})
                words.rgba.push_back(static_cast<std::byte>(channel));
        return std::make_shared<const WordPicture>(words);
    }();
    wall.frame.words = {{.picture = half_white, .place = {{20, 20}, {60, 40}}},
                        {.picture = half_white, .place = {{120, 20}, {160, 40}}, .alpha = 0.5}};

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 30, 30), {255, 255, 255}));
    CHECK(is_near(at(picture, 50, 30), red));
    CHECK(is_near(at(picture, 30, 10), red));
    CHECK(is_near(at(picture, 130, 30), {137, 137, 227}));
    CHECK(is_near(at(picture, 150, 30), blue));

    wall.frame.words.clear();

    CHECK(is_near(at(wall.shown(), 30, 30), red));
}

TEST_CASE("less light makes the whole picture darker, and more gives it back") {
    DrawnWall wall;
    wall.add_two();
    wall.renderer.set_light(0.4);
    const Picture dim = wall.shown();
    wall.renderer.set_light(1);
    const Picture bright = wall.shown();
    const auto darker = [](int value) { return value * 2 / 5; };
    for (const int x : {30, 130}) {
        const auto full = at(bright, x, 30);
        CHECK(is_near(at(dim, x, 30), {darker(full[0]), darker(full[1]), darker(full[2])}));
    }
}

TEST_CASE("a drifting film moves against its drift under its cell, and not where it is seen whole") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    Still picture_of_film = still(100, 100, [](int x, int) { return x < 60 ? red : green; });

    picture_of_film.sample.slide = {30, 0};
    wall.renderer.upload(1, picture_of_film.sample);
    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 25, 50), red));
    CHECK(is_near(at(picture, 35, 50), green));
    wall.frame.items[0].slide_share = 0;
    const Picture whole = wall.shown();
    CHECK(is_near(at(whole, 55, 50), red));
    CHECK(is_near(at(whole, 65, 50), green));
}

TEST_CASE("placement scales and moves the source") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 200, 100)), {20, -40});
    wall.frame.items[0].placement.scale = 2;
    wall.renderer.upload(1,
                         still(100, 100, [](int x, int y) { return x < 50 && y < 50 ? red : green; }).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 110, 50), red));
    CHECK(is_near(at(picture, 130, 50), green));
    CHECK(is_near(at(picture, 110, 70), green));
}

TEST_CASE("a crossfade at one half shows half of each") {
    DrawnWall wall;
    wall.add_two();
    wall.add(3, cell(box(0, 0, 100, 100)), {0, 0});
    wall.frame.items.back().alpha = 0.5;
    wall.renderer.upload(3, plain(green).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 50, 50), {110, 110, 20}));
    CHECK(is_near(at(picture, 150, 50), blue));
}

TEST_CASE("a new sample replaces the old one, also of another size and with padded rows") {
    DrawnWall wall;
    wall.add_two();
    wall.shown();

    Still padded = still(40, 30, [](int x, int) { return x < 32 ? green : red; });
    padded.sample.width = 32;
    wall.renderer.upload(1, padded.sample);
    const Picture picture = wall.shown();

    for (const int x : {5, 50, 95})
        CHECK(is_near(at(picture, x, 50), green));
    CHECK(is_near(at(picture, 150, 50), blue));
}

TEST_CASE("a panel turned to the right shows the canvas' top at its left side") {
    DrawnWall wall(100, 200, {.rotation = Rotation::right});
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(canvas_size(100, 200, {.rotation = Rotation::right}) == Vec2{200, 100});
    CHECK(is_near(at(picture, 50, 190), red));  // the canvas' left side
    CHECK(is_near(at(picture, 50, 10), blue));
    DrawnWall left(100, 200, {.rotation = Rotation::left});
    left.add_two();
    CHECK(is_near(at(left.shown(), 50, 10), red));
    DrawnWall half(200, 100, {.rotation = Rotation::half});
    half.add_two();
    CHECK(is_near(at(half.shown(), 190, 50), red));
}

TEST_CASE("margins stay black, and the canvas fills what they leave") {
    DrawnWall wall(240, 130, {.left = 30, .top = 20, .right = 10, .bottom = 10});
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(at(picture, 29, 60) == Colour{0, 0, 0});
    CHECK(at(picture, 120, 19) == Colour{0, 0, 0});
    CHECK(at(picture, 230, 60) == Colour{0, 0, 0});
    CHECK(at(picture, 120, 120) == Colour{0, 0, 0});
    CHECK(is_near(at(picture, 31, 21), red));
    CHECK(is_near(at(picture, 228, 118), blue));
}

TEST_CASE("a photo shown small is averaged and not picked from") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(1, still(800, 800, [](int x, int) {
                                return x % 2 == 0 ? Colour{0, 0, 0} : Colour{200, 200, 200};
                            }).sample);

    const Picture picture = wall.shown();

    for (const int x : {20, 41, 63, 80})
        CHECK(is_near(at(picture, x, 50), {100, 100, 100}, 5));
}

TEST_CASE(
    "pictures are scaled beforehand where the processor draws, and handed to a graphics card as decoded") {
    for (const char* device : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Google SwiftShader"})
        CHECK(picture_form(device, true) == PictureForm::bgra);
    for (const char* device :
         {"V3D 4.2", "Mesa Intel(R) UHD Graphics (ADL-N)", "AMD Radeon (radeonsi)", "Mali-G610 (Panfrost)"}) {
        CHECK(picture_form(device, false) == PictureForm::planes);
        CHECK(picture_form(device, true) == PictureForm::shared);
    }
    const DrawnWall wall;
    const std::string_view vendor = reinterpret_cast<const char*>(glGetString(GL_VENDOR));
    CHECK(is_software(gl_device()) == vendor.starts_with("Mesa"));  // the tests' device
}
