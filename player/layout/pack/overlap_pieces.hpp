#pragma once

#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine::player {

/// The area of the union of convex polygons, computed in another way than UnionArea, for checks: each polygon
/// less the polygons before it, cut into convex pieces. px^2, in double precision.
/// @param polygons  px, counter-clockwise; an empty one counts nothing
double union_area_by_pieces(std::span<const Polygon> polygons);

}  // namespace vitrine::player
