#pragma once

#include "base/geometry/vec2.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace vitrine::player {

/// When one item is read before another: it stands at least half a line higher, or on the same line and not
/// farther right. Lines go from top to bottom, and on a line from left to right.
/// Source: Dynamic Media Assemblage 5 wishes for it; ALGORITHMS (d) "User order".
struct ReadingOrder {
    static constexpr double margin = 0.02;  // canvas px that a search keeps from all limits

    double half_line = 0;  // canvas px, half the mean height of the items

    bool is_before(Vec2 one, Vec2 other) const {
        const Vec2 by = other - one;
        return by.y >= half_line || (by.y > -half_line && by.x >= 0);
    }

    /// How far `later` has to move to be read after `earlier` with a margin, canvas px along an axis; 0: it
    /// is.
    double violation(Vec2 earlier, Vec2 later) const {
        const Vec2 by = later - earlier;
        const double lower = half_line + margin - by.y;
        const double same_line = std::max(margin - by.x, margin - half_line - by.y);
        return std::max(0.0, std::min(lower, same_line));
    }
};

/// The number of pairs that are not read in the order in which they are given.
/// @param places  where the items stand, canvas px, in the wished order
std::size_t inversions(std::span<const Vec2> places, ReadingOrder order);

}  // namespace vitrine::player
