#pragma once

#include "player/display/offscreen_screen.hpp"
#include "player/render/renderer.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace vitrine::player {

using Colour = std::array<int, 3>;

constexpr Colour red{200, 20, 20};
constexpr Colour green{20, 200, 20};
constexpr Colour blue{20, 20, 200};

/// A picture and its pixels.
struct Still {
    std::vector<std::byte> pixels;
    Sample sample;
};

/// @param paint  the colour at (x, y), px
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

Still plain(Colour colour);

Polygon box(double x0, double y0, double x1, double y1);
std::shared_ptr<const Cell> cell(const Polygon& quad);
std::shared_ptr<const Cell> filler(const Polygon& quad);

/// The distance from a point to the segment between two others, px.
double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

Colour at(const Picture& picture, int x, int y);
bool is_near(Colour a, Colour b, int tolerance = 3);

/// A wall of 200 x 100 px, off screen; its items are 100 x 100 source px.
struct DrawnWall {
    OffscreenScreen screen;
    Renderer renderer;
    Frame frame{.canvas = {200, 100}};

    /// @param egl  none: one of its own
    explicit DrawnWall(int width = 200, int height = 100, const View& view = {},
                       std::shared_ptr<Egl> egl = {});

    void add(SourceId source, std::shared_ptr<const Cell> shape, Vec2 offset);

    /// A red item, 1, at the left and a blue one, 2, at the right.
    void add_two();

    Picture shown();
};

}  // namespace vitrine::player
