#include "player/scene/acts/act_fade.hpp"

#include "player/layout/cells/cut_cell.hpp"
#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto fade_time = std::chrono::milliseconds(800);

/// The same items elsewhere on the canvas.
std::vector<DrawItem> moved_by(std::vector<DrawItem> items, Vec2 way) {
    if (way == Vec2{}) return items;
    for (DrawItem& item : items) {
        item.placement.offset = item.placement.offset + way;
        item.cell = std::make_shared<const Cell>(scaled_cell(*item.cell, 1, way));
    }
    return items;
}

/// Items of a frame some time later: their films play on, in step with the same films in another frame.
std::vector<DrawItem> played_on(std::vector<DrawItem> items, const std::vector<DrawItem>& others,
                                nanoseconds passed) {
    for (DrawItem& item : items) {
        const auto same = std::ranges::find(others, item.source, &DrawItem::source);
        item.local = same != others.end() ? same->local : item.local + passed;
    }
    return items;
}

}  // namespace

void ActFade::begin(Vec2 view, nanoseconds now) {
    before_ = moved_by(std::exchange(last_, {}), view - std::exchange(last_view_, view));
    since_ = now;
}

void ActFade::draw(Frame& frame, nanoseconds now) {
    last_ = frame.items;
    last_view_ = frame.view;
    if (!since_) return;
    const double progress =
        std::chrono::duration<double>(now - *since_) / std::chrono::duration<double>(fade_time);
    if (progress < 1)
        fade_in(frame, played_on(before_, frame.items, now - *since_), progress);
    else
        since_.reset(), before_.clear();
}

}  // namespace vitrine::player
