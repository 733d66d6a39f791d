#include "player/scene/drag.hpp"

#include "player/layout/edit/edit.hpp"
#include "player/layout/plan/plan_request.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double min_way = 1;      // canvas px from the held shot to its wished place
constexpr double held_size = 0.7;  // share of the first scale: a smaller shot needs less room
constexpr double min_seen = 0.85;  // share of the area seen before a step; with less, the held shot waits
constexpr double worth_of_filling =
    3;  // share of the canvas seen that is worth as much as a canvas that pictures fill
constexpr double worth_of_way =
    1;  // share of the canvas seen that is worth as much as the canvas' diagonal between finger and shot

Vec2 place_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

Vec2 place_of(const PlacedShot& placed) {
    return place_of(placed.shot.item, placed.placement);
}

/// The share of the canvas that I-Regions cover.
double seen_of(const WallState& wall) {
    return 1 - layout_of(wall).energy;
}

/// The placement at this scale that puts an item's centroid at a place.
Placement about(const LayoutItem& item, const Placement& at, Vec2 place, double scale) {
    const Vec2 centroid = (seat_of(item, at).centre - at.offset) * (1 / at.scale);
    return {scale, place - centroid * scale};
}

/// The other item whose home is nearest to a place, if it is nearer than the held item's home. None: there is
/// no such item.
std::optional<std::size_t> nearest_home(const WallState& wall, std::size_t held, Vec2 place) {
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

void Drag::let_go() {
    finger_.reset();
    held_.reset();
}

std::optional<std::vector<Placement>> Drag::next_placements(std::span<const PlacedShot> wall, Vec2 canvas) {
    if (!finger_) has_tried_ = false;
    if (finger_ && !has_tried_) take_hold(wall);
    if (!held_) return std::nullopt;
    const PlacedShot* held = find_source(wall, held_->source);
    if (held == nullptr || !finger_) {
        held_.reset();
        return settled(standing_wall(wall, canvas), rules_).placements;
    }
    const Vec2 wish = *finger_ + grip_;
    if (length(wish - place_of(*held)) < min_way) return std::nullopt;
    const auto item = static_cast<std::size_t>(held - wall.data());
    WallState standing = standing_wall(wall, canvas);
    standing.placements[item] = about(wall[item].shot.item, standing.placements[item], place_of(wall[item]),
                                      held_->home.scale * held_size);
    return making_way(standing, item, wish).placements;
}

/// Tries several steps. Takes the one after which most of the shots is seen, the canvas is filled and the
/// held shot is nearest to the finger. In a step the other shots make room from their homes or from their
/// present places; or the shot at the finger changes places with the held shot.
WallState Drag::making_way(const WallState& wall, std::size_t held, Vec2 wish) const {
    WallState here = wall;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        here.homes[i] = about(wall.items[i], wall.homes[i], place_of(wall.items[i], wall.placements[i]),
                              wall.homes[i].scale);
    std::vector<WallState> tries{wall, here};
    for (const WallState& before : {wall, here}) {
        const auto other = nearest_home(before, held, wish);
        if (!other) continue;
        tries.push_back(before);
        tries.back().homes[*other] = tries.back().placements[*other] =
            about(wall.items[*other], wall.homes[*other], place_of(wall.items[held], before.homes[held]),
                  wall.homes[*other].scale);
    }
    const double enough = seen_of(wall) * min_seen;
    const auto worth = [&](const WallState& after) {
        const double way = length(wish - place_of(after.items[held], after.placements[held]));
        return seen_of(after) - worth_of_filling * empty_share(after) -
               worth_of_way * way / length(after.canvas);
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
        if (!is_at(placed, from_)) continue;
        held_ = Held{.source = placed.shot.source, .home = placed.placement};
        grip_ = place_of(placed) - from_;
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
