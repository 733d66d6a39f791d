#include "player/scene/acts/act_fade.hpp"

#include "player/layout/cells/cut_cell.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto fade_time = std::chrono::milliseconds(800);
constexpr double last_part = 0.25;  // of the fade: in it goes what was shown before

/// Places the items elsewhere.
void place_elsewhere(std::vector<DrawItem>& items, const Placement& way) {
    if (way == Placement{}) return;
    for (DrawItem& item : items) {
        item.placement = composed(item.placement, way);
        item.cell = std::make_shared<const Cell>(scaled_cell(*item.cell, way.scale, way.offset));
    }
}

/// Cuts off what the items show outside an outline.
void cut_to(std::vector<DrawItem>& items, const Polygon& outline) {
    for (DrawItem& item : items)
        item.cell = std::make_shared<const Cell>(inside_part(*item.cell, {&outline, 1}));
}

/// A frame some time later: its films play on, in step with the same films in another frame.
LeavingFrame played_on(LeavingFrame frame, const std::vector<DrawItem>& others, nanoseconds passed) {
    for (DrawItem& item : frame.items) {
        const auto same = std::ranges::find(others, item.source, &DrawItem::source);
        item.local = same != others.end() ? same->local : item.local + passed;
    }
    return frame;
}

}  // namespace

void ActFade::begin(Vec2 view, const Placement& place, nanoseconds now) {
    const Vec2 last_view = std::exchange(last_view_, view);
    before_ = std::exchange(last_, {});
    place_elsewhere(before_.items, {place.scale, place.offset + view - last_view * place.scale});
    if (place != Placement{}) {  // shots of a wall that pans go beyond the canvas so far
        const Box seen{{0, 0}, last_canvas_};
        cut_to(before_.items, transformed(to_polygon(seen), place.scale, place.offset + view));
        before_.idle = 1;
    }
    since_ = now;
    canvas_.reset();
}

void ActFade::draw(Frame& frame, nanoseconds now) {
    last_ = {.items = frame.items, .idle = frame.idle};
    last_view_ = frame.view;
    last_canvas_ = frame.canvas;
    if (!since_) return;
    if (!canvas_) canvas_ = frame.canvas;
    const double progress =
        std::chrono::duration<double>(now - *since_) / std::chrono::duration<double>(fade_time);
    if (progress < 1 && canvas_ == frame.canvas)
        fade_in(frame, played_on(before_, frame.items, now - *since_), progress, last_part);
    else
        since_.reset(), before_ = {};
}

}  // namespace vitrine::player
