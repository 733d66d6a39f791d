#pragma once

#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine::player {

/// The area of the union of convex polygons, computed differently from UnionArea, for checks: each polygon
/// without the polygons before it, cut into convex pieces. px^2, in double precision.
/// @param polygons  px, counter-clockwise; empty ones have no area
double union_area_by_pieces(std::span<const Polygon> polygons);

}  // namespace vitrine::player
