#pragma once

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// The area of each placed I-Region, as a share of its fair one. The fair areas are those of the natural
/// scales, with the same sum; none is larger than the enlargement allows.
/// @param max_scale  canvas px per source px
inline std::vector<double> fair_shares(std::span<const LayoutItem> items,
                                       std::span<const Placement> placements, double max_scale) {
    std::vector<Shape> shapes;
    for (const LayoutItem& item : items)
        shapes.push_back(shape_of(item.region));
    const std::vector<double> natural = natural_scales(items, shapes);
    double placed = 0;
    double wished = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        placed += shapes[i].area * placements[i].scale * placements[i].scale;
        wished += shapes[i].area * natural[i] * natural[i];
    }
    std::vector<double> shares;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const double fair = std::min(natural[i] * natural[i] * placed / wished, max_scale * max_scale);
        shares.push_back(placements[i].scale * placements[i].scale / fair);
    }
    return shares;
}

}  // namespace vitrine::player
