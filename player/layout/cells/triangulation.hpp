#pragma once

#include "player/layout/cells/grid.hpp"

#include <array>

namespace vitrine::player {

using GridTriangle = std::array<CellPoint, 3>;

/// Cuts a simple counter-clockwise outline into counter-clockwise triangles by clipping ears, exactly. Every
/// corner of the outline, even on a straight side, becomes a corner of triangles, so outlines with common
/// corners are tiled without cracks. Outlines that touch themselves are cut as far as they have area.
std::vector<GridTriangle> triangulated(const Loop& outline);

/// Adds to each loop the corners of all loops that lie on its sides, so that neighbours share them. A corner
/// lies on a side if it is at most 2 grid steps away.
void share_corners(const std::vector<Loops*>& loops);

}  // namespace vitrine::player
