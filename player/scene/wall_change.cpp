#include "player/scene/wall_change.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/transition_frame.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vitrine::player {

using Phase = WallChange::Phase;
using std::chrono::nanoseconds;

void lay_out(WallChange& change, const Layout& layout, const CellStyle& style) {
    assert(layout.placements.size() == change.wall.size());
    for (std::size_t i = 0; i < change.wall.size(); ++i)
        change.wall[i].placement = layout.placements[i];
    give_cells(change.wall, change.canvas, style);
    change.is_final = layout.is_final;
    // For a first layout that is not final, the sources are requested at once; for later layouts, only when
    // the final one has come.
    if (layout.is_final || !change.waiting_since) change.phase = Phase::laid_out;
}

void choose_layout(WallChange& change, double worth) {
    if (change.calm.empty()) return;
    const double waste = wasted_share(change.wall, change.canvas);
    if (wasted_share(change.calm, change.canvas) < waste + worth)
        change.wall = std::exchange(change.calm, {});
}

void reject_layout(WallChange& change) {
    change.calm = change.wall;
    change.phase = Phase::wasteful;
}

WallPlan plan_anew(WallChange& change, std::uint64_t generation) {
    change.phase = Phase::planned;
    change.generation = generation;
    WallPlan plan{.generation = generation, .canvas = change.canvas};
    for (const PlacedShot& placed : change.calm)
        plan.items.push_back({.item = placed.shot.item});
    return plan;
}

std::vector<ShotRequest> ask_for_sources(WallChange& change, WallSources& sources, nanoseconds now) {
    if (!change.waiting_since) change.waiting_since = now;
    change.phase = Phase::waiting;
    return sources.request(change.wall);
}

bool is_ready(const WallChange& change, const WallSources& sources, bool is_first) {
    const auto is_there = [&](const PlacedShot& placed) { return sources.is_ready(placed); };
    if (!change.is_final) return false;
    return is_first ? std::ranges::any_of(change.wall, is_there) : std::ranges::all_of(change.wall, is_there);
}

TransitionStyle transition_style(const WallChange& change, TransitionStyle usual) {
    if (!change.pace) return usual;
    usual.duration = *change.pace;
    usual.is_even = true;
    return usual;
}

void begin_transition(WallChange& change, std::span<const PlacedShot> shown, const TransitionStyle& style,
                      nanoseconds now) {
    change.began = now;
    change.phase = shown.empty() ? Phase::arriving : Phase::fading;
    if (shown.empty()) {
        for (PlacedShot& placed : change.wall)
            placed.began = never;
        return;
    }
    Transition& made = change.transition.emplace(transition(change.canvas, shown, change.wall, style));
    const nanoseconds appears =
        now + std::chrono::duration_cast<nanoseconds>(made.duration * made.fade_begin);
    for (std::size_t i = 0; i < change.wall.size(); ++i) {
        const PlacedShot* same = find_source(shown, change.wall[i].shot.source);
        change.wall[i].began = made.new_wall[i].placed.began = same != nullptr ? same->began : appears;
    }
}

void let_arrive(WallChange& change, const WallSources& sources, nanoseconds now) {
    for (PlacedShot& placed : change.wall)
        if (placed.began == never && sources.is_ready(placed)) placed.began = now;
}

bool has_ended(const WallChange& change, const WallSources& sources, nanoseconds arrival, nanoseconds now) {
    if (change.phase == Phase::fading) return now - change.began >= change.transition->duration;
    return std::ranges::all_of(change.wall, [&](const PlacedShot& placed) {
        return placed.began == never ? sources.has_failed(placed) : now - placed.began >= arrival;
    });
}

Frame change_frame(const WallChange& change, const TransitionStyle& style, nanoseconds now) {
    if (change.phase == Phase::arriving) return fade_in_each(change.canvas, change.wall, style.duration, now);
    return transition_frame(*change.transition, now - change.began, style.cells, now);
}

}  // namespace vitrine::player
