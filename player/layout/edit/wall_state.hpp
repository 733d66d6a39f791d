#pragma once

#include "player/layout/layout.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::player {

/// A wall that is touched: the place of every item, and the place to which an item goes back that made way
/// for another. A value; each edit (edit.hpp) gives a new one.
struct WallState {
    Vec2 canvas;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one an item
    std::vector<Placement> homes;       // one an item: where it goes back to once it can
    std::vector<bool> pinned;           // one an item: only its own edit moves it
};

/// The settings common to the edits of a wall.
struct EditRules {
    std::uint64_t seed = 1;
    std::int64_t budget = 100'000;      // evaluated moves, limit of one edit
    double clearance = 1.5;             // canvas px between I-Regions
    double margin = 1;                  // canvas px to the canvas' edge
    double max_scale = 1.5;             // canvas px per source px
    std::function<bool()> should_stop;  // then the best found so far is completed and given
};

/// The state of a layout, nothing pinned. @pre a placement an item
WallState wall_state(std::vector<LayoutItem> items, const Layout& layout);

/// The wall as a layout.
Layout layout_of(const WallState& wall);

}  // namespace vitrine::player
