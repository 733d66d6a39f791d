#include "player/render/renderer.hpp"

#include "player/render/uncovered.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double same_place = 1e-3;  // px

bool is_opaque(const DrawItem& item) {
    return item.alpha >= 1;
}

bool is_whole(double value) {
    return std::abs(value - std::round(value)) < same_place;
}

}  // namespace

Renderer::Renderer(int width, int height, const View& view)
    : width_(width), height_(height), view_(view), cells_(pictures_) {
    check_gl("make the renderer");
}

void Renderer::aim(int width, int height, const View& view) {
    assert(is_own_thread());
    width_ = width;
    height_ = height;
    view_ = view;
}

std::optional<std::string> Renderer::upload(SourceId source, const Sample& sample) {
    assert(is_own_thread());
    return pictures_.upload(source, sample);
}

void Renderer::forget(SourceId source) {
    assert(is_own_thread());
    pictures_.forget(source);
}

void Renderer::draw(const Frame& frame) {
    assert(is_own_thread());
    clear();
    const ToNdc view = to_ndc(frame.canvas, view_.rotation);
    draw_idle(frame, view);
    const bool is_on_pixels = is_whole(frame.view.x) && is_whole(frame.view.y) &&
                              frame.canvas == canvas_size(width_, height_, view_);
    const ToNdc moved = seen_from(view, frame.view);
    const std::span<const DrawItem> items = frame.items;
    for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
        draw_plates(frame, begin, moved);
        while (end < items.size() && items[end].alpha == items[begin].alpha &&
               !items[end].zoom == !items[begin].zoom &&
               (end == begin || std::ranges::find(frame.plates, end, &Plate::below) == frame.plates.end()))
            ++end;
        const auto run = items.subspan(begin, end - begin);
        if (run.front().zoom)
            draw_zooms(run, moved);
        else
            cells_.draw(run, moved, is_on_pixels);
    }
    if (!words_ && !frame.words.empty()) words_.emplace();
    if (words_) words_->draw(frame.words, moved);
    if (light_ < 1) {
        if (!dim_) dim_.emplace();
        dim_->draw(light_);
    }
    glBindVertexArray(0);
    cells_.drop_old();
    if (zooms_) zooms_->drop_old();
    check_gl("draw a frame");
}

/// Makes the whole screen black, and limits further drawing to the canvas.
void Renderer::clear() const {
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);

    const int across = width_ - view_.left - view_.right;
    const int down = height_ - view_.top - view_.bottom;
    glViewport(view_.left, view_.bottom, across, down);
    glScissor(view_.left, view_.bottom, across, down);  // limits lines too, which may leave the viewport
    glEnable(GL_SCISSOR_TEST);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

bool Renderer::is_own_thread() const {
    return std::this_thread::get_id() == thread_;
}

bool Renderer::leaves_holes(const Frame& frame) const {
    return std::ranges::none_of(frame.items,
                                [&](const DrawItem& i) { return is_opaque(i) && has(i.source); }) ||
           std::ranges::any_of(frame.items,
                               [&](const DrawItem& i) { return is_opaque(i) && !has(i.source); });
}

/// Draws the idle picture only where it is seen, because it costs more per pixel than pictures do.
void Renderer::draw_idle(const Frame& frame, const ToNdc& view) {
    const bool has_holes = leaves_holes(frame);
    const double opacity = has_holes ? 1 : frame.idle;
    if (opacity <= 0) return;
    const Box all{{0, 0}, frame.canvas};
    if (opacity < 1) {
        glEnable(GL_BLEND);
        return idle_.draw(frame.canvas, view, frame.time, opacity, all);
    }
    glDisable(GL_BLEND);
    for (const Box& part : uncovered(all, has_holes ? std::span<const Box>() : frame.covered)) {
        set_scissor(part, view);
        idle_.draw(frame.canvas, view, frame.time, opacity, part);
    }
    set_scissor(all, view);
}

void Renderer::draw_plates(const Frame& frame, std::size_t below, const ToNdc& view) const {
    for (const Plate& plate : frame.plates) {
        if (plate.below != below) continue;
        set_scissor(plate.box, view);
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        set_scissor({{0, 0}, frame.canvas}, view);
    }
}

/// Limits drawing to all pixels that the part of the canvas touches.
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

void Renderer::draw_zooms(std::span<const DrawItem> items, const ToNdc& view) {
    if (!zooms_) zooms_.emplace();
    for (const DrawItem& item : items) {
        if (!has(item.source)) continue;
        PictureTexture& texture = pictures_.at(item.source);
        texture.bind_sampled(Sampling::smooth, texture.width() / (item.picture.x * item.placement.scale));
        zooms_->draw(item, view);
    }
}

}  // namespace vitrine::player
