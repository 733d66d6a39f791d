#pragma once

#include "base/geometry/polygon.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace vitrine::player {

/// Steps of the cells' grid per canvas px. Neighbouring cells share their corners on it exactly. Boolean
/// operations round to it, so a border is exact to 1/2^15 px.
inline constexpr double cell_grid = 32768;

/// A point of the cells' grid; |x|, |y| < 2^30.
struct CellPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;

    bool operator==(const CellPoint&) const = default;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    auto operator<=>(const CellPoint&) const = default;
};

using Loop = std::vector<CellPoint>;  // closed, not self-crossing
using Loops = std::vector<Loop>;      // outer loops counter-clockwise, holes clockwise

CellPoint to_grid(Vec2 point);
Vec2 from_grid(CellPoint point);
Loop to_grid(const Polygon& polygon);
Polygon from_grid(const Loop& loop);

/// Twice the signed area of a triangle, grid units^2: positive if c lies on the positive-angle side of a ->
/// b.
std::int64_t turn(CellPoint a, CellPoint b, CellPoint c);

/// Twice the signed area, grid units^2.
double twice_area(const Loop& loop);

/// Area of all loops without their holes, canvas px^2.
double area_of(const Loops& loops);

/// Boolean operations by the non-zero rule. The outer loops of the results run counter-clockwise.
Loops intersection_of(const Loops& a, const Loops& b);
Loops difference_of(const Loops& a, const Loops& b);
Loops union_of(const Loops& a, const Loops& b);

/// The area within `distance` px of the loops.
Loops grown(const Loops& loops, double distance);

/// The same area as loops without holes: an outline with a hole is cut open through the hole.
Loops without_holes(const Loops& loops);

}  // namespace vitrine::player
