#pragma once

#include "player/layout/cells/sharing.hpp"

#include <vector>

namespace vitrine::player {

/// Makes each cell one connected piece. A part that lies apart from the item's I-Region goes to the neighbour
/// with the nearest I-Region that has pixels there. What no neighbour has pixels for stays.
/// @param shown  one for each item; together they keep their area
void give_far_parts(std::vector<Loops>& shown, const ItemAreas& items);

}  // namespace vitrine::player
