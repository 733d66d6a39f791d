#include "player/scene/transition.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cassert>

namespace vitrine::player {

namespace {

using Shots = std::vector<PlacedShot>;

constexpr double shrinking = 0.93;      // factor of each try to shrink a slot's last shot that is in the way
constexpr double min_remainder = 0.55;  // share of its scale; below it the shot fades out first
constexpr double clearance = 1.0 / 64;  // canvas px

bool is_free(const LayoutItem& item, const Placement& at, std::span<const PlacedShot> others) {
    return std::all_of(others.begin(), others.end(), [&](const PlacedShot& other) {
        return overlap_interval({item, at, at}, {other.shot.item, other.placement, other.placement},
                                clearance)
            .is_empty();
    });
}

/// The place where a slot's last shot waits for its next one among the shots that have moved. None: it would
/// be too small.
std::optional<Placement> making_room(const PlacedShot& last, std::span<const PlacedShot> moved) {
    const Vec2 place = seat_of(last.shot.item, last.placement).centre;
    const Vec2 centroid = (place - last.placement.offset) * (1 / last.placement.scale);
    double factor = 1;
    Placement at = last.placement;
    while (factor >= min_remainder) {
        if (is_free(last.shot.item, at, moved)) return at;
        factor *= shrinking;
        const double scale = last.placement.scale * factor;
        at = {scale, place - centroid * scale};
    }
    return std::nullopt;
}

/// The shots that stay while others come and go, before and after their motion.
struct StayingShots {
    Shots before;
    Shots after;
};

StayingShots staying_shots(std::span<const PlacedShot> shown, std::span<const PlacedShot> incoming) {
    Shots moved;
    for (const PlacedShot& placed : incoming)
        if (find_source(shown, placed.shot.source) != nullptr) moved.push_back(placed);
    StayingShots staying;
    for (const PlacedShot& placed : shown) {
        PlacedShot after = placed;
        if (const PlacedShot* same = find_source(incoming, placed.shot.source)) {
            after.placement = same->placement;
        } else {
            if (find_slot(incoming, placed.shot.slot) == nullptr) continue;
            const auto room = making_room(placed, moved);
            if (!room) continue;
            after.placement = *room;
        }
        staying.before.push_back(placed);
        staying.after.push_back(after);
    }
    return staying;
}

std::optional<Motion> motion_of(const StayingShots& staying, Vec2 canvas) {
    std::vector<LayoutItem> items;
    std::vector<Placement> from;
    std::vector<Placement> to;
    for (std::size_t i = 0; i < staying.before.size(); ++i) {
        items.push_back(staying.before[i].shot.item);
        from.push_back(staying.before[i].placement);
        to.push_back(staying.after[i].placement);
    }
    return motion_between(items, from, to, canvas);
}

}  // namespace

std::vector<Act> transition(Vec2 canvas, std::span<const PlacedShot> shown,
                            std::span<const PlacedShot> incoming, const TransitionStyle& style) {
    const Shots first(shown.begin(), shown.end());
    const Shots last(incoming.begin(), incoming.end());
    std::vector<Act> fade{{.from = first, .to = last, .duration = style.crossfade}};
    if (style.motion.count() <= 0 || first.empty() || last.empty()) return fade;
    StayingShots stays = staying_shots(shown, incoming);
    const auto motion = motion_of(stays, canvas);
    if (!motion || motion->kind == Motion::Kind::still) return fade;
    std::vector<Act> acts;
    if (stays.before.size() < first.size()) {
        give_cells(stays.before, canvas, style.cells);
        acts.push_back({.from = first, .to = stays.before, .duration = style.crossfade});
    }
    const int stages = motion->kind == Motion::Kind::straight ? 1 : 2;
    acts.push_back({.from = stays.before,
                    .motion = motion,
                    .duration = style.motion * stages,
                    .is_even = style.is_even});
    const bool is_anything_new = std::any_of(last.begin(), last.end(), [&](const PlacedShot& placed) {
        return find_source(shown, placed.shot.source) == nullptr;
    });
    if (!is_anything_new) return acts;
    give_cells(stays.after, canvas, style.cells);
    acts.push_back({.from = stays.after, .to = last, .duration = style.crossfade});
    return acts;
}

std::chrono::nanoseconds duration_of(std::span<const Act> acts) {
    std::chrono::nanoseconds sum{0};
    for (const Act& act : acts)
        sum += act.duration;
    return sum;
}

Frame transition_frame(Vec2 canvas, const TransitionTime& time, const CellStyle& style,
                       std::chrono::nanoseconds now) {
    assert(!time.acts.empty());
    std::chrono::nanoseconds passed = time.passed;
    std::size_t at = 0;
    while (at + 1 < time.acts.size() && passed >= time.acts[at].duration)
        passed -= time.acts[at++].duration;
    const Act& act = time.acts[at];
    const double progress = act.duration.count() > 0 ? std::chrono::duration<double>(passed) /
                                                           std::chrono::duration<double>(act.duration)
                                                     : 1;
    if (!act.motion) return crossfade(canvas, act.from, act.to, progress, now);
    Shots moving = act.from;
    const std::vector<Placement> placements =
        placements_at(*act.motion, act.is_even ? progress : eased(progress));
    for (std::size_t i = 0; i < moving.size(); ++i)
        moving[i].placement = placements[i];
    give_cells(moving, canvas, style);
    return standing_frame(canvas, moving, now);
}

}  // namespace vitrine::player
