#include "player/render/renderer.hpp"

#include "player/render/picture_program.hpp"
#include "player/render/uncovered.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double same_place = 1e-3;     // px
constexpr double max_viewport = 16384;  // px of a side

bool is_opaque(const DrawItem& item) {
    return item.alpha >= 1;
}

Vec2 ndc_of(const ToNdc& view, Vec2 point) {
    return view.x_axis * point.x + view.y_axis * point.y + view.origin;
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
    prepare_pictures(frame);
    clear();
    const ToNdc view = look_at(frame.canvas);
    draw_idle(frame, view);
    const Box part = seen_part(view_, frame.canvas);
    const Vec2 first = frame.view + part.min;  // the canvas point in a corner of the screen
    const bool is_on_pixels =
        is_whole(first.x) && is_whole(first.y) && part.max - part.min == canvas_size(width_, height_, view_);
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

/// Here, and not while the screen is drawn to: each change of the frame buffer makes a card that draws by
/// tiles, and Mesa's software renderer, store and load all that is drawn so far.
void Renderer::prepare_pictures(const Frame& frame) {
    for (const DrawItem& item : frame.items) {
        if (item.alpha <= 0 || !has(item.source)) continue;
        PictureTexture& picture = pictures_.at(item.source);
        picture.prepare(texels_a_px(picture, item));
        if (!item.zoom && cells_.has_filler(item)) picture.reduced().prepare_filler();
    }
}

/// Makes the whole screen black.
void Renderer::clear() const {
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

/// Sets the viewport, and limits further drawing to what the screen shows of the canvas. If the whole canvas
/// would lie on whole pixels, the viewport is that of all of it: a part is then drawn with the same numbers,
/// and so with the same pixels, as the whole.
ToNdc Renderer::look_at(Vec2 canvas) {
    const int across = width_ - view_.left - view_.right;
    const int down = height_ - view_.top - view_.bottom;
    glScissor(view_.left, view_.bottom, across, down);
    glEnable(GL_SCISSOR_TEST);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    const Box part = seen_part(view_, canvas);
    const ToNdc whole = to_ndc(canvas, view_.rotation);
    const Vec2 a = ndc_of(whole, part.min);
    const Vec2 b = ndc_of(whole, part.max);
    const Vec2 size{2 * across / std::abs(b.x - a.x), 2 * down / std::abs(b.y - a.y)};
    const Vec2 first{view_.left - (std::min(a.x, b.x) + 1) / 2 * size.x,
                     view_.bottom - (std::min(a.y, b.y) + 1) / 2 * size.y};
    const bool is_whole_px = is_whole(first.x) && is_whole(first.y) && is_whole(size.x) && is_whole(size.y) &&
                             std::max(size.x, size.y) <= max_viewport;
    viewport_ = is_whole_px ? Box{first, first + size}
                            : Box{{1.0 * view_.left, 1.0 * view_.bottom},
                                  {1.0 * (view_.left + across), 1.0 * (view_.bottom + down)}};
    const auto px = [](double length) { return static_cast<GLint>(std::lround(length)); };
    glViewport(px(viewport_.min.x), px(viewport_.min.y), px(viewport_.width()), px(viewport_.height()));
    return is_whole_px ? whole : seen_from(to_ndc(part.max - part.min, view_.rotation), part.min);
}

bool Renderer::is_own_thread() const {
    return std::this_thread::get_id() == thread_;
}

bool Renderer::leaves_holes(const Frame& frame) const {
    const auto has_base = [&](const DrawItem& i) { return is_opaque(i) && has(i.source); };
    const auto is_missing = [&](const DrawItem& i) {
        return (is_opaque(i) || frame.is_fade) && !has(i.source);
    };
    return (!frame.is_fade && std::ranges::none_of(frame.items, has_base)) ||
           std::ranges::any_of(frame.items, is_missing);
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

/// Limits drawing to all pixels that the part of the canvas touches and the screen shows.
void Renderer::set_scissor(const Box& part, const ToNdc& view) const {
    const auto px = [&](Vec2 point) {
        const Vec2 ndc = ndc_of(view, point);
        return viewport_.min +
               Vec2{(ndc.x + 1) / 2 * viewport_.width(), (ndc.y + 1) / 2 * viewport_.height()};
    };
    const Vec2 a = px(part.min);
    const Vec2 b = px(part.max);
    const auto across = [&](double place) {
        return static_cast<GLint>(
            std::lround(std::clamp(place, 1.0 * view_.left, 1.0 * (width_ - view_.right))));
    };
    const auto up = [&](double place) {
        return static_cast<GLint>(
            std::lround(std::clamp(place, 1.0 * view_.bottom, 1.0 * (height_ - view_.top))));
    };
    const GLint left = across(std::floor(std::min(a.x, b.x) + same_place));
    const GLint bottom = up(std::floor(std::min(a.y, b.y) + same_place));
    glScissor(left, bottom, across(std::ceil(std::max(a.x, b.x) - same_place)) - left,
              up(std::ceil(std::max(a.y, b.y) - same_place)) - bottom);
}

void Renderer::draw_zooms(std::span<const DrawItem> items, const ToNdc& view) {
    if (!zooms_) zooms_.emplace();
    for (const DrawItem& item : items) {
        if (!has(item.source)) continue;
        pictures_.at(item.source).bind_sampled(Sampling::smooth);
        zooms_->draw(item, view);
    }
}

}  // namespace vitrine::player
