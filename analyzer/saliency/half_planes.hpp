#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine::analyzer {

/// The points p with dot(p, normal) <= offset.
struct HalfPlane {
    Vec2 normal;  // outward, unit length
    double offset = 0;
};

/// The part of a convex counter-clockwise polygon inside all half-planes; empty where there is none.
Polygon cut_by(Polygon convex, std::span<const HalfPlane> planes);

/// The polygon with every edge moved outward by a distance; corners stay sharp.
/// @pre convex, counter-clockwise, of positive area
Polygon widened(const Polygon& convex, double distance);

/// The polygon with at most `corners` corners, grown where needed and never cut into: the edge is dropped
/// whose neighbours meet with the smallest area added. At least 4 corners; fewer cannot always be had.
/// @pre convex, counter-clockwise, of positive area
Polygon simplified_outward(Polygon convex, std::size_t corners);

/// simplified_outward() inside a box: never outside it, and never more than `corners` corners.
/// @pre corners >= 8; the polygon lies inside the box
Polygon simplified_within(const Polygon& convex, std::size_t corners, const Box& box);

}  // namespace vitrine::analyzer
