#include "player/scene/drag.hpp"

#include "player/layout/edit/edit.hpp"
#include "player/layout/plan/plan_request.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double least_way = 1;      // canvas px from what is held to where it shall be
constexpr double held_size = 0.7;    // of the scale that it was taken with: it needs less room on its way
constexpr double least_seen = 0.85;  // of what was seen before a step: else what is held waits
constexpr double worth_of_way = 1;   // share of the canvas seen, for the diagonal between finger and held

Vec2 place_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

Vec2 place_of(const PlacedShot& placed) {
    return place_of(placed.shot.item, placed.placement);
}

/// Share of the canvas that I-Regions cover.
double seen_of(const WallState& wall) {
    return 1 - layout_of(wall).energy;
}

/// Whether a point lies in an outline, by the edges left of it; of any shape.
bool is_in(std::span<const Vec2> outline, Vec2 point) {
    bool is_inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
}

/// The placement at which an item has its centroid at a place.
Placement about(const LayoutItem& item, const Placement& at, Vec2 place, double scale) {
    const Vec2 centroid = (seat_of(item, at).centre - at.offset) * (1 / at.scale);
    return {scale, place - centroid * scale};
}

/// Which other item's home is nearest to a place, nearer than that of what is held.
std::optional<std::size_t> whose_place(const WallState& wall, std::size_t held, Vec2 place) {
    const auto way = [&](std::size_t i) {
        return length(seat_of(wall.items[i], wall.homes[i]).centre - place);
    };
    std::size_t nearest = held;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        if (way(i) < way(nearest)) nearest = i;
    if (nearest == held) return std::nullopt;
    return nearest;
}

}  // namespace

bool is_touched(const PlacedShot& placed, Vec2 point) {
    const auto is_in_one = [&](const std::vector<Polygon>& outlines) {
        return std::any_of(outlines.begin(), outlines.end(),
                           [&](const Polygon& outline) { return is_in(outline, point); });
    };
    return placed.cell && (is_in_one(placed.cell->parts) || is_in_one(placed.cell->filler));
}

void Drag::forget() {
    finger_.reset();
    held_ = 0;
}

std::optional<std::pair<SourceId, Placement>> Drag::held() const {
    if (held_ == 0) return std::nullopt;
    return std::pair{held_, home_};
}

std::optional<std::vector<Placement>> Drag::step(std::span<const PlacedShot> wall, Vec2 canvas) {
    if (!finger_) has_tried_ = false;
    if (finger_ && !has_tried_) take_hold(wall);
    if (!is_holding()) return std::nullopt;
    const auto held = std::find_if(wall.begin(), wall.end(),
                                   [&](const PlacedShot& placed) { return placed.shot.source == held_; });
    if (held == wall.end() || !finger_) {
        held_ = 0;
        return settled(standing_wall(wall, canvas), rules_).placements;
    }
    const Vec2 wish = *finger_ + grip_;
    if (length(wish - place_of(*held)) < least_way) return std::nullopt;
    const auto item = static_cast<std::size_t>(held - wall.begin());
    WallState standing = standing_wall(wall, canvas);
    standing.placements[item] =
        about(wall[item].shot.item, standing.placements[item], place_of(wall[item]), home_.scale * held_size);
    return making_way(standing, item, wish).placements;
}

/// The step after which most is seen and what is held is nearest to the finger: the others make way where
/// they were, or where they are, or the one whose place is taken changes to the place that what is held came
/// from.
WallState Drag::making_way(const WallState& wall, std::size_t held, Vec2 wish) const {
    WallState here = wall;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        here.homes[i] = about(wall.items[i], wall.homes[i], place_of(wall.items[i], wall.placements[i]),
                              wall.homes[i].scale);
    std::vector<WallState> tries{wall, here};
    for (const WallState& before : {wall, here}) {
        const auto other = whose_place(before, held, wish);
        if (!other) continue;
        tries.push_back(before);
        tries.back().homes[*other] = tries.back().placements[*other] =
            about(wall.items[*other], wall.homes[*other], place_of(wall.items[held], before.homes[held]),
                  wall.homes[*other].scale);
    }
    const double enough = seen_of(wall) * least_seen;
    const auto worth = [&](const WallState& after) {
        const double way = length(wish - place_of(after.items[held], after.placements[held]));
        return seen_of(after) - worth_of_way * way / length(after.canvas);
    };
    WallState best = wall;
    for (const WallState& before : tries) {
        WallState after = dragged(before, held, wish, rules_);
        if (after.placements == before.placements || seen_of(after) < enough) continue;
        if (best.placements == wall.placements || worth(after) > worth(best)) best = std::move(after);
    }
    return best;
}

void Drag::take_hold(std::span<const PlacedShot> wall) {
    has_tried_ = true;
    homes_.clear();
    for (const PlacedShot& placed : wall) {
        if (!is_touched(placed, from_)) continue;
        held_ = placed.shot.source;
        grip_ = place_of(placed) - from_;
        home_ = placed.placement;
    }
    for (const PlacedShot& placed : wall)
        homes_[placed.shot.source] = placed.placement;
}

WallState Drag::standing_wall(std::span<const PlacedShot> wall, Vec2 canvas) const {
    WallState standing{.canvas = canvas};
    for (const PlacedShot& placed : wall) {
        const auto home = homes_.find(placed.shot.source);
        standing.items.push_back(placed.shot.item);
        standing.placements.push_back(placed.placement);
        standing.homes.push_back(home == homes_.end() ? placed.placement : home->second);
        standing.pinned.push_back(false);
    }
    return standing;
}

}  // namespace vitrine::player
