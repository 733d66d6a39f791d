// What a renderer draws where nothing else is.

#include "player/render/renderer.hpp"
#include "player/render/uncovered.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double same_place = 1e-3;  // px of the screen

}  // namespace

/// Only where it is seen, as it costs more a pixel than pictures do.
void Renderer::draw_idle(const Frame& frame, const ToNdc& view) {
    const bool has_holes = leaves_holes(frame);
    const double opacity = has_holes ? 1 : frame.idle;
    if (opacity <= 0) return;
    const Box all{{0, 0}, frame.canvas};
    if (opacity < 1) {
        glEnable(GL_BLEND);
        return idle_.draw(frame.canvas, view, frame.time, opacity, 0, frame.canvas.y);
    }
    glDisable(GL_BLEND);
    for (const Box& part : uncovered(all, has_holes ? std::span<const Box>() : frame.covered)) {
        set_scissor(part, view);
        idle_.draw(frame.canvas, view, frame.time, opacity, part.min.y, part.max.y);
    }
    set_scissor(all, view);
}

/// To all pixels of which a part of the canvas has some.
void Renderer::set_scissor(const Box& part, const ToNdc& view) const {
    const Vec2 room{static_cast<double>(width_ - view_.left - view_.right),
                    static_cast<double>(height_ - view_.top - view_.bottom)};
    const auto px = [&](Vec2 point) {
        const Vec2 ndc = view.x_axis * point.x + view.y_axis * point.y + view.origin;
        return Vec2{view_.left + (ndc.x + 1) / 2 * room.x, view_.bottom + (ndc.y + 1) / 2 * room.y};
    };
    const Vec2 a = px(part.min);
    const Vec2 b = px(part.max);
    const auto edge = [](double place) { return static_cast<GLint>(std::lround(place)); };
    const GLint left = edge(std::floor(std::min(a.x, b.x) + same_place));
    const GLint bottom = edge(std::floor(std::min(a.y, b.y) + same_place));
    glScissor(left, bottom, edge(std::ceil(std::max(a.x, b.x) - same_place)) - left,
              edge(std::ceil(std::max(a.y, b.y) - same_place)) - bottom);
}

}  // namespace vitrine::player
