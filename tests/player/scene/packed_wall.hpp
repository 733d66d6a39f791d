#pragma once

#include "player/layout/plan/plan.hpp"
#include "player/scene/wall_cells.hpp"

#include <vector>

namespace vitrine::player {

/// The canvas of a packed wall, px.
constexpr Vec2 packed_canvas{640, 360};

/// A wall with cells: shots 1, 2, ... in the slots 0, 1, ..., of three sizes, packed on packed_canvas.
inline std::vector<PlacedShot> packed_wall(int count) {
    PlanRequest request{.canvas = packed_canvas, .budget = 20'000};
    for (int i = 0; i < count; ++i) {
        const double width = 120 + 20 * (i % 3);
        request.items.push_back(
            {.item = {.region = to_polygon({{200, 100}, {200 + width, 220}}), .core = {{0, 0}, {640, 360}}}});
    }
    const Layout layout = plan(request);
    std::vector<PlacedShot> wall;
    for (std::size_t i = 0; i < layout.placements.size(); ++i)
        wall.push_back({.shot = {.source = i + 1,
                                 .slot = static_cast<int>(i),
                                 .picture = request.items[i].item.core.max,
                                 .item = request.items[i].item},
                        .placement = layout.placements[i]});
    give_cells(wall, packed_canvas, {});
    return wall;
}

/// The centroid of a shot's I-Region, canvas px.
inline Vec2 centre_of(const PlacedShot& placed) {
    return seat_of(placed.shot.item, placed.placement).centre;
}

}  // namespace vitrine::player
