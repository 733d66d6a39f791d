#pragma once

#include "base/geometry/polygon.hpp"

namespace vitrine {

/// The convex hull, counter-clockwise, without collinear corners, starting at the lexicographically
/// smallest point. The points may have duplicates, equal x and collinear parts: pixel masks always do.
/// @return  fewer than three corners if the points span no area
/// Source: Dynamic Media Assemblage A.1. Differs: Andrew's monotone chain on points sorted by (x, y); the
/// 3-coin scan of the thesis is right only on suitably ordered input.
Polygon convex_hull(std::span<const Vec2> points);

}  // namespace vitrine
