#pragma once

#include "player/layout/layout.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <cstddef>
#include <vector>

namespace vitrine::player {

/// Pairs of a layout that are not read in the order of the items; line height and places measured anew.
inline std::size_t inversions_of(const std::vector<LayoutItem>& items, const Layout& layout) {
    std::vector<Vec2> places;
    double height = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const Polygon region = placed_region(items[i], layout.placements[i]);
        places.push_back(centroid(region));
        height += bounding_box(region).height();
    }
    return inversions(places, {height / (2 * static_cast<double>(items.size()))});
}

}  // namespace vitrine::player
