#pragma once

#include "base/geometry/vec2.hpp"

#include <algorithm>

namespace vitrine::player {

/// An item is read before another if it is at least half a line higher, or on the same line and not farther
/// right. Lines go from top to bottom, and a line from left to right.
/// Source: Dynamic Media Assemblage 5 suggests it; docs/algorithms.md, (d) "User order".
struct ReadingOrder {
    static constexpr double margin = 0.02;  // canvas px that a search keeps from all limits

    double half_line = 0;  // canvas px, half the mean height of the items

    /// The distance along an axis by which `later` must move to be read after `earlier` with a margin, canvas
    /// px; 0: it is read after it.
    double violation(Vec2 earlier, Vec2 later) const {
        const Vec2 by = later - earlier;
        const double lower = half_line + margin - by.y;
        const double same_line = std::max(margin - by.x, margin - half_line - by.y);
        return std::max(0.0, std::min(lower, same_line));
    }
};

}  // namespace vitrine::player
