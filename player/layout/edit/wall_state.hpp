#pragma once

#include "player/layout/canvas.hpp"
#include "player/layout/layout.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::player {

/// A wall that is touched: the place of every item, and the home to which an item returns after making room
/// for another. A value.
struct WallState {
    Canvas canvas;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one for each item
    std::vector<Placement> homes;       // one for each item: it returns there when it can
    std::vector<std::size_t> pinned;    // items that keep their places and show nothing
};

/// The settings of the ways of a wall.
struct EditRules {
    std::uint64_t seed = 1;
    std::int64_t budget = 100'000;      // evaluated moves of one way at most
    double clearance = 1.5;             // canvas px between I-Regions
    double margin = 0;                  // canvas px between I-Regions and the canvas' edge
    double max_scale = 1.5;             // canvas px per source px
    std::function<bool()> should_stop;  // true: the best layout so far is completed and returned
};

/// The state of a layout. @pre one placement for each item
WallState wall_state(std::vector<LayoutItem> items, const Layout& layout);

/// The layout of the wall.
Layout layout_of(const WallState& wall);

}  // namespace vitrine::player
