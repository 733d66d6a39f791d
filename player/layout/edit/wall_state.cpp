#include "player/layout/edit/wall_state.hpp"

#include "player/layout/plan/plan_request.hpp"

#include <cassert>
#include <utility>

namespace vitrine::player {

WallState wall_state(std::vector<LayoutItem> items, const Layout& layout) {
    assert(items.size() == layout.placements.size());
    return {.canvas = layout.canvas,
            .items = std::move(items),
            .placements = layout.placements,
            .homes = layout.placements};
}

Layout layout_of(const WallState& wall) {
    double covered = 0;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        covered += seat_of(wall.items[i], wall.placements[i]).area;
    return {.canvas = wall.canvas,
            .placements = wall.placements,
            .energy = 1 - covered / (wall.canvas.x * wall.canvas.y),
            .is_final = true};
}

}  // namespace vitrine::player
