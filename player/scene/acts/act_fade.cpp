#include "player/scene/acts/act_fade.hpp"

#include "player/layout/cells/cut_cell.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto fade_time = std::chrono::milliseconds(800);
constexpr double last_part = 0.25;  // of the fade: in it goes what was shown before

/// The same items elsewhere on the canvas. @param seen  if any: the part that is left of them
std::vector<DrawItem> transformed(std::vector<DrawItem> items, const Placement& by,
                                  const std::optional<Polygon>& seen) {
    if (by == Placement{}) return items;
    for (DrawItem& item : items) {
        item.placement = composed(item.placement, by);
        const Cell cell = scaled_cell(*item.cell, by.scale, by.offset);
        item.cell = std::make_shared<const Cell>(seen ? inside_part(cell, {&*seen, 1}) : cell);
    }
    return items;
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
    const Placement way{place.scale, place.offset + view - last_view * place.scale};
    const bool is_elsewhere = place != Placement{};
    std::optional<Polygon> seen;  // of the canvas so far; shots of a wall that pans go beyond it
    if (is_elsewhere)
        seen =
            vitrine::transformed(to_polygon(Box{last_view, last_view + last_canvas_}), way.scale, way.offset);
    before_ = std::exchange(last_, {});
    before_.items = transformed(std::move(before_.items), way, seen);
    if (is_elsewhere) before_.idle = 1;
    since_ = now;
}

void ActFade::draw(Frame& frame, nanoseconds now) {
    last_ = {.items = frame.items, .idle = frame.idle};
    last_view_ = frame.view;
    last_canvas_ = frame.canvas;
    if (!since_) return;
    const double progress =
        std::chrono::duration<double>(now - *since_) / std::chrono::duration<double>(fade_time);
    if (progress < 1)
        fade_in(frame, played_on(before_, frame.items, now - *since_), progress, last_part);
    else
        since_.reset(), before_ = {};
}

}  // namespace vitrine::player
