#include "player/scene/wall_change.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/transition_frame.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vitrine::player {

using Phase = WallChange::Phase;
using std::chrono::nanoseconds;

namespace {

bool is_drifting(const PlacedShot& placed) {
    return placed.drift.from != placed.drift.to;
}

/// Puts a photo that drifts on the wall before or after a way to its place on the way. @param share  of it
void let_drift(DrawItem& item, const PlacedShot& before, PlacedShot after, double share, nanoseconds now) {
    const bool begins = is_drifting(after);
    if (!begins && !is_drifting(before)) return;
    after.placement = item.placement;
    after.cell = item.cell;
    const PhotoDrift& drift = begins ? after.drift : before.drift;
    item.placement.offset =
        after.placement.offset + drift_within_cell(after, drift, begins ? share : 1 - share, now);
}

/// The next moment of a way. A shot in a hand is still seen in the place that it leaves.
Frame way_frame(const WallChange& change, std::span<const PlacedShot> shown, nanoseconds now) {
    if (now < change.began) return standing_frame(change.canvas, shown, now);
    const std::vector<WallKey>& keys = change.way->keys;
    const double share = std::clamp(std::chrono::duration<double>(now - change.began) /
                                        std::chrono::duration<double>(change.duration),
                                    0.0, 1.0);
    const auto passed = static_cast<std::size_t>(share * static_cast<double>(keys.size()));
    const WallKey& key = keys[std::min(passed, keys.size() - 1)];
    Frame frame = standing_frame(change.canvas, change.wall, now);
    for (std::size_t i = 0; i < frame.items.size(); ++i) {
        DrawItem& item = frame.items[i];
        item.alpha = std::min(key.alphas[i], key.alphas[i] < 1 ? max_blended : 1);
        const bool is_in_hand = change.wall[i].is_above;
        item.placement = is_in_hand ? shown[i].placement : key.placements[i];
        item.cell = is_in_hand ? shown[i].cell : key.cells[i];
        if (!is_in_hand) let_drift(item, shown[i], change.wall[i], share, now);
    }
    return frame;
}

}  // namespace

void lay_out(WallChange& change, const Layout& layout, const CellStyle& style) {
    assert(layout.placements.size() >= change.wall.size());
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
        plan.items.push_back({.item = placed.shot.item, .group = placed.group});
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

TouchedWall take_way(WallChange& change, std::shared_ptr<const WallWay> way) {
    const WallKey& last = way->keys.back();
    for (std::size_t i = 0; i < change.wall.size(); ++i) {
        change.wall[i].placement = last.placements[i];
        change.wall[i].cell = last.cells[i];
        change.wall[i].is_above = last.alphas[i] < 1;
    }
    change.way = std::move(way);
    return {.shots = change.wall, .canvas = change.canvas};
}

void begin_way(WallChange& change, std::span<const PlacedShot> shown, bool drifts, nanoseconds now) {
    for (PlacedShot& placed : change.wall)
        placed.drift = {};
    if (drifts) give_drifts(change.wall, shown, change.canvas.bands);
    change.began = now;
    change.phase = Phase::fading;
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
    const auto is_awaited = [&](const PlacedShot& placed) {
        return placed.began == never && !sources.is_ready(placed) && !sources.has_failed(placed);
    };
    for (PlacedShot& placed : change.wall) {
        const bool lacks_copy = std::ranges::any_of(change.wall, [&](const PlacedShot& other) {
            return other.shot.key == placed.shot.key && is_awaited(other);
        });
        if (placed.began == never && sources.is_ready(placed) && !lacks_copy) placed.began = now;
    }
}

bool has_ended(const WallChange& change, const WallSources& sources, nanoseconds arrival, nanoseconds now) {
    if (change.way) return now - change.began >= change.duration;
    if (change.phase == Phase::fading) return now - change.began >= change.transition->duration;
    return std::ranges::all_of(change.wall, [&](const PlacedShot& placed) {
        return placed.began == never ? sources.has_failed(placed) : now - placed.began >= arrival;
    });
}

Frame change_frame(const WallChange& change, std::span<const PlacedShot> shown, const TransitionStyle& style,
                   nanoseconds now) {
    if (change.way) return way_frame(change, shown, now);
    if (change.phase == Phase::arriving) return fade_in_each(change.canvas, change.wall, style.duration, now);
    return transition_frame(*change.transition, now - change.began, style.cells, now);
}

}  // namespace vitrine::player
