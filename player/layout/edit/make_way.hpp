#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/edit/wall_state.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::player {

/// A place that a visitor gives an item: under a finger, larger where it is, or where it was let go.
struct Wish {
    std::size_t item = 0;
    Placement at;
    bool is_let_go = false;  // it may move and grow to its former size from there, and stays then
};

/// The wall after wishes. Every item without a wish stands at its home, or as near as the wishes allow: none
/// moves farther from home than a quarter of the canvas' diagonal. So the places depend on the homes and the
/// wishes only, and an item returns exactly once nothing is in its place. A wish that cannot be given room
/// becomes smaller; one that is on another is not heard.
///
/// An item that was let go, and all others, keep the places that they get: their homes.
/// @param wishes  at most one for each item; the first ones go before
WallState made_way(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules);

/// A moment on the way from one wall to the next.
struct WallKey {
    std::vector<Placement> placements;               // one for each item
    std::vector<std::shared_ptr<const Cell>> cells;  // one for each item
};

/// The way from one wall to another, as keys at equal intervals of time. The last key is the other wall.
struct WallWay {
    std::vector<WallKey> keys;     // at least one
    std::vector<Placement> homes;  // of the wall after it
    bool is_free = true;           // false: some items have no free way, and the last key fades in
};

/// A change of a wall that is touched, and all that is needed to make it on another thread.
struct WayRequest {
    WallState wall;                   // where the items are, and their homes
    std::vector<Wish> wishes;         // none: all go home
    std::vector<Vec2> pictures;       // source px, one for each item
    std::vector<LayoutGroup> groups;  // a group moves as a whole, as if its hull were one item
    CellStyle cells;
    std::size_t keys = 6;  // on the way, with the last
    EditRules rules;
};

/// The way of a wall to what is wished.
WallWay way_to(const WayRequest& request);

}  // namespace vitrine::player
