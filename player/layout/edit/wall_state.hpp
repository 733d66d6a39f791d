#pragma once

#include "player/layout/layout.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace vitrine::player {

/// A wall that stands and is touched: where every item is, and where those would be that made way for
/// something that may pass by. A value; each edit gives a new one.
///
/// Every edit succeeds and what it gives is free of overlap, inside the canvas and final; the others move as
/// little as they can. What finds no room becomes smaller, the newcomer or what is touched first, then all
/// that is not pinned. The same wall, edit and seed give the same.
/// Source: ALGORITHMS (d) "Slots rotating"; the paper packs anew (3.4), which moves everything.
struct Standing {
    Vec2 canvas;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one an item
    std::vector<Placement> homes;       // one an item: where it goes back to once it can
    std::vector<bool> pinned;           // one an item: no edit but its own moves it
};

/// What is common to the edits of a wall.
struct EditRules {
    std::uint64_t seed = 1;
    std::int64_t budget = 100'000;      // evaluated moves, the most an edit takes
    double clearance = 1.5;             // canvas px between I-Regions
    double margin = 1;                  // canvas px to the canvas' edge
    double most_scale = 1.5;            // canvas px per source px
    std::function<bool()> should_stop;  // then what has been found so far is completed and given
};

}  // namespace vitrine::player
