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

/// The same items elsewhere on the canvas.
std::vector<DrawItem> moved_by(std::vector<DrawItem> items, Vec2 way) {
    if (way == Vec2{}) return items;
    for (DrawItem& item : items) {
        item.placement.offset = item.placement.offset + way;
        item.cell = std::make_shared<const Cell>(scaled_cell(*item.cell, 1, way));
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

void ActFade::begin(Vec2 view, nanoseconds now) {
    before_ = std::exchange(last_, {});
    before_.items = moved_by(std::move(before_.items), view - std::exchange(last_view_, view));
    since_ = now;
}

void ActFade::draw(Frame& frame, nanoseconds now) {
    last_ = {.items = frame.items, .idle = frame.idle};
    last_view_ = frame.view;
    if (!since_) return;
    const double progress =
        std::chrono::duration<double>(now - *since_) / std::chrono::duration<double>(fade_time);
    if (progress < 1)
        fade_in(frame, played_on(before_, frame.items, now - *since_), progress, last_part);
    else
        since_.reset(), before_ = {};
}

}  // namespace vitrine::player
