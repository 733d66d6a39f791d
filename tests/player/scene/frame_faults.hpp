#pragma once

#include "player/layout/cells/grid.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/transition_frame.hpp"

#include <vector>

namespace vitrine::player {

/// Faults of a frame of a transition, canvas px^2. A frame should have none.
struct FrameFaults {
    double covered = 0;  // of the I-Regions of shots that move
    double bare = 0;     // of the canvas, where nothing is drawn opaque
    double dark = 0;     // of filler that neither the old nor the new wall has
    double twice = 0;    // of the I-Regions of shots that move, seen at another place than they are at
};

inline Loops grid_loops(const std::vector<Polygon>& outlines) {
    Loops loops;
    for (const Polygon& outline : outlines)
        loops.push_back(to_grid(outline));
    return loops;
}

/// The part of a moving shot's I-Region that a frame does not show, or shows below another shot.
inline double covered_part(const Frame& frame, const ChangingShot& shot, const Placement& at) {
    const Loops region{to_grid(placed_region(shot.placed.shot.item, at))};
    Loops seen;
    for (const DrawItem& item : frame.items) {
        const Loops parts = intersection_of(region, grid_loops(item.cell->parts));
        const bool is_own = item.source == shot.placed.shot.source && item.placement == at;
        if (is_own && item.alpha >= 1) seen = union_of(seen, parts);
        if (!is_own) seen = difference_of(seen, parts);
    }
    return area_of(difference_of(region, seen));
}

/// The part of a moving shot's I-Region that a frame shows at another place than where the shot is.
inline double part_seen_twice(const Frame& frame, const ChangingShot& shot, const Placement& at) {
    Loops seen;
    for (const DrawItem& item : frame.items) {
        const Loops parts = grid_loops(item.cell->parts);
        const bool is_twin = item.source == shot.placed.shot.source && item.placement != at;
        if (is_twin) {
            const Loops region{to_grid(placed_region(shot.placed.shot.item, item.placement))};
            seen = union_of(seen, intersection_of(region, parts));
        } else if (item.alpha >= max_blended) {
            seen = difference_of(seen, parts);
        }
    }
    return area_of(seen);
}

/// The faults of a transition's frame. @param share  of the duration
inline FrameFaults faults_of(const Transition& transition, double share, const CellStyle& style = {}) {
    using namespace std::chrono;
    const auto passed = duration_cast<nanoseconds>(transition.duration * share);
    const Frame frame = transition_frame(transition, passed, style, {});
    const double exact = duration<double>(passed).count() / duration<double>(transition.duration).count();
    const std::vector<Placement> placements = placements_at(transition, exact);
    FrameFaults faults;
    for (const ChangingShot& shot : transition.old_wall) {
        if (!shot.moving) continue;
        faults.covered += covered_part(frame, shot, placements[*shot.moving]);
        faults.twice += part_seen_twice(frame, shot, placements[*shot.moving]);
    }
    Loops drawn;
    Loops filler;
    for (const DrawItem& item : frame.items) {
        filler = union_of(filler, grid_loops(item.cell->filler));
        if (item.alpha < 1) continue;
        drawn = union_of(drawn, grid_loops(item.cell->parts));
        drawn = union_of(drawn, grid_loops(item.cell->filler));
    }
    for (const auto* wall : {&transition.old_wall, &transition.new_wall})
        for (const ChangingShot& shot : *wall)
            filler = difference_of(filler, grid_loops(shot.placed.cell->filler));
    faults.bare = transition.canvas.x * transition.canvas.y - area_of(drawn);
    faults.dark = area_of(filler);
    return faults;
}

}  // namespace vitrine::player
