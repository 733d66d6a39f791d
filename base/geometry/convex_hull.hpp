#pragma once

#include "base/geometry/polygon.hpp"

namespace vitrine {

/// The convex hull, counter-clockwise, without collinear corners, starting at the lexicographically
/// smallest point. Duplicates, equal x and collinear points are the rule (pixel masks), not the
/// exception: fewer than three corners come back where the points span no area.
/// Source: Dynamic Media Assemblage A.1; Andrew's monotone chain on points sorted by (x, y) instead of
/// the thesis' 3-coin scan, which is right only on suitably ordered input.
Polygon convex_hull(std::span<const Vec2> points);

}  // namespace vitrine
