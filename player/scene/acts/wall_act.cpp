#include "player/scene/acts/wall_act.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

/// The frame of a panning wall.
Frame pan_frame(const WallAct& act, std::chrono::nanoseconds now) {
    const double view = act.pan->course.at(now) - act.pan->origin;
    std::vector<PlacedShot> seen;
    for (const PlacedShot& placed : act.shown) {
        const Box bounds = bounds_of(*placed.cell);
        if (bounds.max.x > view && bounds.min.x < view + act.canvas.x) seen.push_back(placed);
    }
    Frame frame = standing_frame(act.canvas, seen, now);
    frame.view = {view, 0};
    return frame;
}

}  // namespace

const std::vector<PlacedShot>& last_wall(const WallAct& act) {
    return act.change ? act.change->wall : act.shown;
}

bool has_ended(const WallAct& act, std::chrono::nanoseconds now) {
    if (!act.change) return true;
    const WallChange& change = *act.change;
    if (change.way) return now - change.began >= change.duration;
    if (change.transition) return now - change.began >= change.transition->duration;
    return std::ranges::all_of(change.wall, [&](const PlacedShot& placed) {
        return placed.began == never || now - placed.began >= act.fade;
    });
}

Frame act_frame(const WallAct& act, std::chrono::nanoseconds now) {
    if (act.pan) return pan_frame(act, now);
    if (has_ended(act, now)) return standing_frame(act.canvas, last_wall(act), now);
    return change_frame(*act.change, act.shown, {.duration = act.fade, .cells = act.cells}, now);
}

std::map<SourceId, const PlacedShot*> shots_of(const WallAct& act) {
    std::map<SourceId, const PlacedShot*> shots;
    for (const PlacedShot& placed : last_wall(act))
        shots.emplace(placed.shot.source, &placed);
    for (const PlacedShot& placed : act.shown)
        shots.emplace(placed.shot.source, &placed);
    return shots;
}

}  // namespace vitrine::player
