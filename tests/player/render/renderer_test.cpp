#include "player/render/renderer.hpp"

#include "player/display/offscreen_screen.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

using Colour = std::array<int, 3>;

constexpr Colour red{200, 20, 20};
constexpr Colour green{20, 200, 20};
constexpr Colour blue{20, 20, 200};

struct Still {
    std::vector<std::byte> pixels;
    Sample sample;
};

template <typename Paint> Still still(int width, int height, Paint paint) {
    Still made;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Colour c = paint(x, y);
            for (const int channel : {c[0], c[1], c[2], 255})
                made.pixels.push_back(static_cast<std::byte>(channel));
        }
    made.sample = {.width = width, .height = height, .stride = static_cast<std::size_t>(width) * 4};
    made.sample.pixels = made.pixels;
    return made;
}

Still plain(Colour colour) {
    return still(64, 64, [&](int, int) { return colour; });
}

void append_quad(std::vector<std::array<Vec2, 3>>& triangles, const Polygon& quad) {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
}

std::shared_ptr<const Cell> cell(const Polygon& quad) {
    Cell made{.parts = {quad}};
    append_quad(made.triangles, quad);
    return std::make_shared<const Cell>(made);
}

std::shared_ptr<const Cell> filler(const Polygon& quad) {
    Cell made{.filler = {quad}};
    append_quad(made.filler_triangles, quad);
    return std::make_shared<const Cell>(made);
}

Polygon box(double x0, double y0, double x1, double y1) {
    return to_polygon(Box{{x0, y0}, {x1, y1}});
}

Colour at(const Picture& picture, int x, int y) {
    const std::byte* p =
        picture.pixels.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                 static_cast<std::size_t>(x)) *
                                    4;
    return {std::to_integer<int>(p[0]), std::to_integer<int>(p[1]), std::to_integer<int>(p[2])};
}

bool is_near(Colour a, Colour b, int tolerance = 3) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(a[i] - b[i]) > tolerance) return false;
    return true;
}

// A wall of 200 x 100 px, an item of 100 x 100 source px at the left, another at the right.
struct Wall {
    OffscreenScreen screen;
    Renderer renderer;
    Frame frame{.canvas = {200, 100}};

    explicit Wall(int width = 200, int height = 100, const View& view = {})
        : screen({.width = width, .height = height}), renderer(width, height, view) {}

    void add(SourceId source, std::shared_ptr<const Cell> shape, Vec2 offset) {
        frame.items.push_back(
            {.source = source, .cell = std::move(shape), .placement = {1, offset}, .picture = {100, 100}});
    }

    void add_two() {
        add(1, cell(box(0, 0, 100, 100)), {0, 0});
        add(2, cell(box(100, 0, 200, 100)), {100, 0});
        renderer.upload(1, plain(red).sample);
        renderer.upload(2, plain(blue).sample);
    }

    Picture shown() {
        screen.begin_frame();
        renderer.draw(frame);
        screen.present(frame.time);
        return screen.picture();
    }
};

}  // namespace

TEST_CASE("each cell shows its own source") {
    Wall wall;
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 2, 2), red));
    CHECK(is_near(at(picture, 97, 97), red));
    CHECK(is_near(at(picture, 102, 2), blue));
    CHECK(is_near(at(picture, 197, 97), blue));
}

TEST_CASE("a picture stands upright and unmirrored on the wall") {
    Wall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(
        1, still(100, 100, [](int x, int y) { return y < 50 ? (x < 50 ? red : green) : blue; }).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 10, 10), red));
    CHECK(is_near(at(picture, 90, 10), green));
    CHECK(is_near(at(picture, 10, 90), blue));
}

TEST_CASE("a drifting film moves against its drift under its cell") {
    Wall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(1, still(100, 100, [](int x, int) { return x < 60 ? red : green; }).sample);

    wall.frame.items[0].slide = {30, 0};
    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 25, 50), red));
    CHECK(is_near(at(picture, 35, 50), green));
}

TEST_CASE("placement scales and moves the source") {
    Wall wall;
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
    Wall wall;
    wall.add_two();
    wall.add(3, cell(box(0, 0, 100, 100)), {0, 0});
    wall.frame.items.back().alpha = 0.5;
    wall.renderer.upload(3, plain(green).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 50, 50), {110, 110, 20}));
    CHECK(is_near(at(picture, 150, 50), blue));
}

TEST_CASE("filler shows the picture's mirror, darkened") {
    Wall wall;
    wall.add(1, filler(box(100, 0, 200, 100)), {0, 0});
    wall.renderer.upload(1, still(100, 100, [](int x, int) { return x < 50 ? red : green; }).sample);

    const Picture picture = wall.shown();

    const auto dark = [](Colour c) { return Colour{c[0] * 35 / 100, c[1] * 35 / 100, c[2] * 35 / 100}; };
    CHECK(is_near(at(picture, 110, 50), dark(green)));
    CHECK(is_near(at(picture, 190, 50), dark(red)));
}

TEST_CASE("a new sample replaces the old one, also of another size and with padded rows") {
    Wall wall;
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
    Wall wall(100, 200, {.rotation = Rotation::right});
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(canvas_size(100, 200, {.rotation = Rotation::right}) == Vec2{200, 100});
    CHECK(is_near(at(picture, 50, 190), red));  // the canvas' left side
    CHECK(is_near(at(picture, 50, 10), blue));
    Wall left(100, 200, {.rotation = Rotation::left});
    left.add_two();
    CHECK(is_near(at(left.shown(), 50, 10), red));
    Wall half(200, 100, {.rotation = Rotation::half});
    half.add_two();
    CHECK(is_near(at(half.shown(), 190, 50), red));
}

TEST_CASE("margins stay black, and the canvas fills what they leave") {
    Wall wall(240, 130, {.left = 30, .top = 20, .right = 10, .bottom = 10});
    wall.add_two();

    const Picture picture = wall.shown();

    CHECK(at(picture, 29, 60) == Colour{0, 0, 0});
    CHECK(at(picture, 120, 19) == Colour{0, 0, 0});
    CHECK(at(picture, 230, 60) == Colour{0, 0, 0});
    CHECK(at(picture, 120, 120) == Colour{0, 0, 0});
    CHECK(is_near(at(picture, 31, 21), red));
    CHECK(is_near(at(picture, 228, 118), blue));
}

TEST_CASE("no black shows between cells that meet in corners and slanted sides") {
    // Given seven slices round a point off the pixel grid, each side cut in three by a corner of the
    // neighbour.
    Wall wall;
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
    Wall wall;
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
    Wall wall(320, 180);
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

TEST_CASE("a photo shown small is averaged and not picked from") {
    Wall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(1, still(800, 800, [](int x, int) {
                                return x % 2 == 0 ? Colour{0, 0, 0} : Colour{200, 200, 200};
                            }).sample);

    const Picture picture = wall.shown();

    for (const int x : {20, 41, 63, 80})
        CHECK(is_near(at(picture, x, 50), {100, 100, 100}, 5));
}
