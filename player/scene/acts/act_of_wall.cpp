#include "player/scene/acts/act_of_wall.hpp"

#include <vector>

namespace vitrine::player {

namespace {

/// The change as it is seen: without what was needed to come to it.
WallChange seen_change(const WallChange& change) {
    return {.phase = change.phase,
            .generation = change.generation,
            .canvas = change.canvas,
            .wall = change.wall,
            .is_final = true,
            .duration = change.duration,
            .way = change.way,
            .began = change.began,
            .transition = change.transition};
}

}  // namespace

WallAct act_of(const WallParts& parts, const TransitionStyle& style) {
    WallAct act{.canvas = parts.canvas,
                .cells = style.cells,
                .fade = style.duration,
                .shown = {parts.shown.begin(), parts.shown.end()}};
    if (!parts.change || !parts.change->is_fading()) return act;
    act.change = seen_change(*parts.change);
    act.canvas = parts.change->canvas;
    if (!act.change->transition) return act;
    act.shown.clear();  // as the transition has it, on its own canvas
    for (const ChangingShot& shot : act.change->transition->old_wall)
        act.shown.push_back(shot.placed);
    return act;
}

LiftedMoment lifted_moment(const WallParts& parts, std::chrono::nanoseconds now) {
    LiftedMoment moment = parts.lifted.moment(now);
    moment.film = parts.film;
    return moment;
}

std::map<SourceId, std::optional<StoredShot>> stored_files(const WallParts& parts) {
    std::map<SourceId, std::optional<StoredShot>> files;
    for (const PlacedShot& placed : parts.shown)
        files[placed.shot.source] = placed.shot.shot.stored;
    if (parts.change)
        for (const PlacedShot& placed : parts.change->wall)
            files[placed.shot.source] = placed.shot.shot.stored;
    return files;
}

}  // namespace vitrine::player
