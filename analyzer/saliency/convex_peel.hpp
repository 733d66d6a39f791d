#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine {

/// What a region must keep while it is made smaller.
struct PeelLimits {
    double mass = 0.5;     // share of the map's whole saliency that must stay inside
    double cheapness = 1;  // a slab is cut only where its mass per area is below so many times the map's mean
    double most_area = 1;  // share of the map; above it slabs are cut whatever they hold
    std::span<const Box> whole;  // px of the map; never cut into
};

/// A small convex region that holds the share of the map's saliency: from the whole of `within`, again and
/// again the slab with least saliency per area is cut off, among 24 directions and several thicknesses.
///
/// @param map     CV_32FC1, values >= 0, not all 0
/// @param within  px of the map; the result stays inside, even where `whole` does not
/// @return        convex, counter-clockwise, px of the map, at most 28 corners; empty where `within` is
/// Source: Dynamic Media Assemblage 3.3 asks for the hull of the pixels with half the mass; stray pixels make
/// that hull most of the picture, while its purpose is the smallest convex region worth preserving.
Polygon peeled(const SaliencyMap& map, const Box& within, const PeelLimits& limits);

}  // namespace vitrine
