#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/edit/make_way.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace vitrine::player {

/// A moment on the way from one wall to the next.
///
/// The cells of the items with an opacity of 1 cover the canvas. Those of the others lie above them: they are
/// of items that fade from place to place, or of lifted ones, which are drawn above the wall.
struct WallKey {
    std::vector<Placement> placements;               // one for each item
    std::vector<std::shared_ptr<const Cell>> cells;  // one for each item
    std::vector<double> alphas;                      // one for each item: its cell's opacity, in [0, 1]
};

/// The way from one wall to another, as keys at equal intervals of time. The last key is the other wall.
struct WallWay {
    std::vector<WallKey> keys;     // at least one
    std::vector<Placement> homes;  // of the wall after it
    std::size_t wayless = 0;       // items or groups without a free way: they fade from place to place
};

/// An item that is drawn above the wall. The cells of the others cover its place, at the end of a way only if
/// it is in a hand.
struct LiftedItem {
    std::size_t item = 0;
    bool is_seen = true;  // its place is still seen on the wall before the way
};

/// A change of a wall that is touched, and all that is needed to make it on another thread.
struct WayRequest {
    WallState wall;                   // where the items are, and their homes
    std::vector<Wish> wishes;         // none: all go home
    std::vector<LiftedItem> lifted;   // those of groups do not count
    std::vector<Vec2> pictures;       // source px, one for each item
    std::vector<LayoutGroup> groups;  // a group moves as a whole, as if its hull were one item
    CellStyle cells;
    std::size_t keys = 6;  // on the way, with the last
    EditRules rules;
};

/// The way of a wall to what is wished. Items that are not lifted never cover one another's I-Regions.
WallWay way_to(const WayRequest& request);

}  // namespace vitrine::player
