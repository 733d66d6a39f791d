#pragma once

#include "player/layout/layout.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <cstddef>
#include <vector>

namespace vitrine::player {

/// The definition of the reading order: at least half a line higher, or on the same line and not farther
/// right.
inline bool is_read_before(Vec2 one, Vec2 other, ReadingOrder order) {
    const Vec2 by = other - one;
    return by.y >= order.half_line || (by.y > -order.half_line && by.x >= 0);
}

/// Pairs of a layout that are not read in the order of the items; line height and places measured anew.
inline std::size_t inversions_of(const std::vector<LayoutItem>& items, const Layout& layout) {
    std::vector<Vec2> places;
    double height = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Polygon region = placed_region(items[i], layout.placements[i]);
        places.push_back(centroid(region));
        height += bounding_box(region).height();
    }
    const ReadingOrder order{height / (2 * static_cast<double>(items.size()))};
    std::size_t count = 0;
    for (std::size_t j = 0; j < places.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
            if (!is_read_before(places[i], places[j], order)) ++count;
    return count;
}

}  // namespace vitrine::player
