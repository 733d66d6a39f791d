#include "tests/player/render/drawn_wall.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace vitrine::player {

namespace {

void append_quad(std::vector<std::array<Vec2, 3>>& triangles, const Polygon& quad) {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
}

}  // namespace

Still plain(Colour colour) {
    return still(64, 64, [&](int, int) { return colour; });
}

Polygon box(double x0, double y0, double x1, double y1) {
    return to_polygon(Box{{x0, y0}, {x1, y1}});
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
    return length(p - (a + along * t));
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

Colour at(const Picture& picture, int x, int y) {
    const std::byte* p =
        picture.pixels.data() + (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                 static_cast<std::size_t>(x)) *
                                    4;
    return {std::to_integer<int>(p[0]), std::to_integer<int>(p[1]), std::to_integer<int>(p[2])};
}

bool is_near(Colour a, Colour b, int tolerance) {
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(a[i] - b[i]) > tolerance) return false;
    return true;
}

DrawnWall::DrawnWall(int width, int height, const View& view, std::shared_ptr<Egl> egl)
    : screen({.width = width, .height = height}, std::move(egl)), renderer(width, height, view) {}

void DrawnWall::add(SourceId source, std::shared_ptr<const Cell> shape, Vec2 offset) {
    frame.items.push_back(
        {.source = source, .cell = std::move(shape), .placement = {1, offset}, .picture = {100, 100}});
}

void DrawnWall::add_two() {
    add(1, cell(box(0, 0, 100, 100)), {0, 0});
    add(2, cell(box(100, 0, 200, 100)), {100, 0});
    renderer.upload(1, plain(red).sample);
    renderer.upload(2, plain(blue).sample);
}

Picture DrawnWall::shown() {
    screen.begin_frame();
    renderer.draw(frame);
    screen.present(frame.time);
    return screen.picture();
}

}  // namespace vitrine::player
