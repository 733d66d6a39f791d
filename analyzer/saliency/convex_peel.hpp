#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine::analyzer {

/// The limits of a region that is made smaller; masses are shares of the map's whole saliency, areas shares
/// of the map.
struct PeelLimits {
    double safe_mass = 0.95;   // kept where saliency is spread widely
    double tight_mass = 0.64;  // if this much fits into tight_area, the region is tight
    double tight_area = 0.4;
    double snug_mass = 0.9;      // a tight region keeps no more than this, so it may get smaller still
    double max_area = 1;         // above it slabs are cut whatever their mass
    std::span<const Box> whole;  // px of the map; never cut into
};

/// A small convex region around a map's saliency: from the whole of `within`, again and again the slab with
/// least saliency per area is cut off, among 24 directions and several thicknesses. Where the saliency is
/// gathered, as much of it is kept as fits into the tight area; where it is spread, the subject is not known,
/// and nearly all is kept.
///
/// @param map     CV_32FC1, values >= 0, not all 0
/// @param within  px of the map; the result stays inside, even where `whole` does not
/// @return        convex, counter-clockwise, px of the map, at most 28 corners; empty where `within` is
/// Source: Dynamic Media Assemblage 3.3 asks for the hull of the pixels with half the mass; stray pixels make
/// that hull most of the picture, while its purpose is the smallest convex region worth preserving.
Polygon peeled(const SaliencyMap& map, const Box& within, const PeelLimits& limits);

}  // namespace vitrine::analyzer
