#pragma once

#include "player/layout/cells/grid.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// True if these can be the Voronoi cells of disjoint convex regions: no corner of a cell on the canvas is
/// nearer to another region than to its own, by more than half a px, and no cell is smaller than its region.
/// @param cells  one for each region
bool are_nearest(std::span<const Loops> cells, std::span<const Polygon> regions, const Box& canvas);

}  // namespace vitrine::player
