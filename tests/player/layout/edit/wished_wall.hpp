#pragma once

#include "player/layout/edit/make_way.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

namespace vitrine::player {

/// A planned wall of random items.
inline WallState planned_wall(std::size_t count, std::uint64_t seed) {
    const PlanRequest request = random_request(count, seed);
    return wall_state(items_of(request), plan(request));
}

inline Vec2 middle_of(const WallState& wall, std::size_t item, const Placement& at) {
    return seat_of(wall.items[item], at).centre;
}

/// The item at its home, moved so that its centroid is at a place, at three quarters of its size.
inline Wish wish_at(const WallState& wall, std::size_t item, Vec2 place) {
    const Placement& home = wall.homes[item];
    const Vec2 middle = middle_of(wall, item, home);
    return {.item = item, .at = {home.scale * 0.75, place - (middle - home.offset) * 0.75}};
}

inline const EditRules quick_rules{.budget = 20'000, .max_scale = 4};

}  // namespace vitrine::player
