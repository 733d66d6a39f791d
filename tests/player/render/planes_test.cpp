
#include "player/playback/colour_code.hpp"
#include "tests/player/render/drawn_wall.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A plain colour as a film codes it.
std::array<double, 3> coded(Colour colour, const ColourCode& code) {
    const double kr = code.matrix == ColourCode::Matrix::bt601 ? 0.299 : 0.2126;
    const double kb = code.matrix == ColourCode::Matrix::bt601 ? 0.114 : 0.0722;
    const double r = colour[0] / 255.0;
    const double g = colour[1] / 255.0;
    const double b = colour[2] / 255.0;
    const double y = kr * r + (1 - kr - kb) * g + kb * b;
    const double cb = (b - y) / (2 - 2 * kb);
    const double cr = (r - y) / (2 - 2 * kr);
    if (code.is_full_range) return {255 * y, 128 + 255 * cb, 128 + 255 * cr};
    return {16 + 219 * y, 128 + 224 * cb, 128 + 224 * cr};
}

/// The left half red, the right half green, in planes with padded rows.
Still halves(int width, int height, PixelLayout layout, const ColourCode& code) {
    Still made;
    const auto rows = static_cast<std::size_t>(height);
    const std::size_t stride = static_cast<std::size_t>(width) + 6;
    const bool is_nv12 = layout == PixelLayout::nv12;
    const std::size_t half = is_nv12 ? stride / 2 * 2 + 4 : stride / 2 + 3;
    const std::size_t half_rows = (rows + 1) / 2;
    made.pixels.resize(stride * rows + 2 * half * half_rows);
    const auto first = coded(red, code);
    const auto second = coded(green, code);
    const auto value = [&](int x, int across, std::size_t channel) {
        return static_cast<std::byte>(std::lround(2 * x < across ? first[channel] : second[channel]));
    };
    for (std::size_t y = 0; y < rows; ++y)
        for (int x = 0; x < width; ++x)
            made.pixels[y * stride + static_cast<std::size_t>(x)] = value(x, width, 0);
    const int across = (width + 1) / 2;
    for (std::size_t y = 0; y < half_rows; ++y)
        for (int x = 0; x < across; ++x)
            for (std::size_t channel = 1; channel < 3; ++channel) {
                const auto column = static_cast<std::size_t>(x);
                const std::size_t place = is_nv12 ? y * half + 2 * column + channel - 1
                                                  : (channel - 1) * half * half_rows + y * half + column;
                made.pixels[stride * rows + place] = value(x, across, channel);
            }
    const std::span<const std::byte> bytes = made.pixels;
    made.sample = {.width = width,
                   .height = height,
                   .stride = stride,
                   .pixels = bytes.first(stride * rows),
                   .layout = layout,
                   .colours = code};
    made.sample.chroma[0] = {half, bytes.subspan(stride * rows, half * half_rows)};
    if (!is_nv12) made.sample.chroma[1] = {half, bytes.subspan(stride * rows + half * half_rows)};
    return made;
}

const std::array<ColourCode, 4> codes{
    ColourCode{ColourCode::Matrix::bt601, false}, ColourCode{ColourCode::Matrix::bt601, true},
    ColourCode{ColourCode::Matrix::bt709, false}, ColourCode{ColourCode::Matrix::bt709, true}};

}  // namespace

TEST_CASE("the decoder's planes show the colours that were coded, whatever the code and the layout") {
    for (const PixelLayout layout : {PixelLayout::i420, PixelLayout::nv12}) {
        for (const ColourCode& code : codes) {
            CAPTURE(static_cast<int>(layout));
            CAPTURE(static_cast<int>(code.matrix));
            CAPTURE(code.is_full_range);
            DrawnWall wall;
            wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
            wall.renderer.upload(1, halves(62, 34, layout, code).sample);

            const Picture picture = wall.shown();

            CHECK(is_near(at(picture, 10, 50), red, 4));
            CHECK(is_near(at(picture, 90, 50), green, 4));
        }
    }
}

TEST_CASE("planes with an odd number of columns and rows are drawn to their last") {
    for (const PixelLayout layout : {PixelLayout::i420, PixelLayout::nv12}) {
        DrawnWall wall;
        wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
        wall.renderer.upload(1, halves(33, 17, layout, codes[2]).sample);

        const Picture picture = wall.shown();

        CHECK(is_near(at(picture, 1, 99), red, 4));
        CHECK(is_near(at(picture, 99, 99), green, 4));
    }
}

TEST_CASE("shared planes that the display cannot read are copied, which is told once a source") {
    DrawnWall wall;
    CHECK_FALSE(wall.renderer.reads_shared_planes());  // off screen
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    const auto made = halves(62, 34, PixelLayout::nv12, codes[0]);
    Sample shared{.width = 62, .height = 34, .layout = PixelLayout::nv12, .colours = codes[0]};
    shared.shared = SharedPlanes{};
    shared.copied = [&] { return std::optional(made.sample); };

    CHECK(wall.renderer.upload(1, shared));
    CHECK_FALSE(wall.renderer.upload(1, shared));

    const Picture picture = wall.shown();
    CHECK(is_near(at(picture, 10, 50), red, 4));
    CHECK(is_near(at(picture, 90, 50), green, 4));
    wall.renderer.forget(1);
    CHECK(wall.renderer.upload(1, shared));
}

TEST_CASE("a source may go from planes to RGBA and back") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.renderer.upload(1, halves(64, 64, PixelLayout::nv12, codes[0]).sample);
    wall.shown();
    wall.renderer.upload(1, plain(blue).sample);
    CHECK(is_near(at(wall.shown(), 10, 50), blue));
    wall.renderer.upload(1, halves(64, 64, PixelLayout::i420, codes[0]).sample);
    CHECK(is_near(at(wall.shown(), 10, 50), red, 4));
}

TEST_CASE("planes fade, and fill what is left of a cell, as RGBA does") {
    DrawnWall wall;
    wall.add(1, cell(box(0, 0, 100, 100)), {0, 0});
    wall.add(2, filler(box(100, 0, 200, 100)), {100, 0});
    wall.add(3, cell(box(0, 0, 100, 100)), {0, 0});
    wall.frame.items.back().alpha = 0.5;
    wall.renderer.upload(1, plain(blue).sample);
    for (const SourceId source : {2, 3})
        wall.renderer.upload(source, halves(64, 64, PixelLayout::i420, codes[0]).sample);

    const Picture picture = wall.shown();

    CHECK(is_near(at(picture, 10, 50), {110, 20, 110}, 4));
    const Colour dark = at(picture, 105, 50);
    CHECK(dark[0] > 20);
    CHECK(dark[0] < 100);
}

TEST_CASE("a picture of the very size it is shown at is shown pixel for pixel, also between two pixels") {
    const auto stripes = [](int x, int y) {
        return (x + y) % 2 == 0 ? Colour{0, 0, 0} : Colour{250, 250, 250};
    };
    for (const double offset : {0.0, 0.3, 0.499, 0.7}) {
        CAPTURE(offset);
        DrawnWall wall;
        wall.add(1, cell(box(0, 0, 100, 100)), {offset, offset / 2});
        wall.frame.items[0].picture = {200.4, 201};
        wall.frame.items[0].placement.scale = 0.5;
        wall.renderer.upload(1, still(100, 100, stripes).sample);

        const Picture picture = wall.shown();

        for (int x = 10; x < 90; ++x) {
            const int sharp = at(picture, x, 50)[0];
            CHECK((sharp == 0 || sharp == 250));
            CHECK(sharp != at(picture, x + 1, 50)[0]);
        }
    }
}
