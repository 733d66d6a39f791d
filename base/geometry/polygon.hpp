#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/vec2.hpp"

#include <span>
#include <vector>

namespace vitrine {

/// Corners of a closed outline, the last joined to the first.
/// Counter-clockwise means a positive signed_area() in the (x, y) plane of the numbers.
using Polygon = std::vector<Vec2>;

/// Half the sum of x dy - y dx: positive if the corners run counter-clockwise, 0 for fewer than three
/// corners.
double signed_area(std::span<const Vec2> polygon);

/// |signed_area|.
double area(std::span<const Vec2> polygon);

/// Centre of mass; the mean of the corners if the area is 0. @pre the polygon is not empty
Vec2 centroid(std::span<const Vec2> polygon);

/// @pre the polygon is not empty
Box bounding_box(std::span<const Vec2> polygon);

/// The corners of a box, counter-clockwise.
Polygon to_polygon(const Box& box);

/// Every corner p becomes p * scale + offset.
Polygon transformed(std::span<const Vec2> polygon, double scale, Vec2 offset);

/// Tells if a point lies inside a convex counter-clockwise polygon or on its outline, with a `tolerance` in
/// the polygon's unit.
bool is_inside_convex(std::span<const Vec2> polygon, Vec2 point, double tolerance = 1e-9);

/// The part of a convex polygon inside a box; empty if they only touch. The result is convex.
Polygon clipped(std::span<const Vec2> convex, const Box& box);

}  // namespace vitrine
