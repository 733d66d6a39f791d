#pragma once

#include "player/layout/layout.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// An I-Region prepared for packing: relative to its centroid, which then is its place.
struct Shape {
    Polygon outline;  // convex, counter-clockwise, source px from the centroid, at least 3 corners
    Vec2 centroid;    // source px
    Box extent;       // box around the outline
    double radius = 0;
    double area = 0;  // source px^2, > 0
};

/// The shape of a region. A region without area (no point, one point, a line) becomes the thinnest box around
/// it with a width of 1 px.
Shape shape_of(std::span<const Vec2> region);

/// Relative scales by the items' weights: equal core area times weight; then each region's size is limited to
/// [1/2, 2] of the median. A sliver counts as large as a box of its length and a tenth of it; else it would
/// be enlarged without bound.
/// @return one factor for each item, canvas px per source px up to one common factor
/// Source: docs/algorithms.md, (d) "Scale normalisation", s_i = sqrt(w_i A0 / (W_i H_i)); the paper gives no
/// rule.
std::vector<double> natural_scales(std::span<const LayoutItem> items, std::span<const Shape> shapes);

/// Shapes with one scale each. Both are borrowed.
struct ScaledShapes {
    std::span<const Shape> shapes;
    std::span<const double> scales;  // canvas px per source px

    std::size_t size() const { return shapes.size(); }

    double area(std::size_t item) const { return shapes[item].area * scales[item] * scales[item]; }

    /// The box of a shape's outline relative to its centroid, canvas px.
    Box extent(std::size_t item) const {
        return {shapes[item].extent.min * scales[item], shapes[item].extent.max * scales[item]};
    }
};

/// The box around all shapes at their places, px.
Box bounds_of(const ScaledShapes& shapes, std::span<const Vec2> places);

}  // namespace vitrine::player
