#pragma once

#include "player/layout/cells/grid.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// The conversion of outlines into Voronoi sites.
struct VoronoiSites {
    double spacing = 0;  // px between sampled points; 0: the outlines themselves, exact
    double inset = 0;    // px, depth of sampled points inside the outline
};

/// The Voronoi diagram of disjoint convex polygons: for each polygon, the points that are nearer to it than
/// to any other. Neighbours share the corners of their common border to the last bit. Curves are flattened to
/// 0.25 px.
///
/// @param regions  canvas px, convex, pairwise disjoint, inside `canvas`
/// @param canvas   the diagram is defined inside it
/// @return         the outlines of each region's cell: one loop, in the sampled mode perhaps several
/// Source: Dynamic Media Assemblage 3.5 and A.2. Differs: exact sites by default (Boost.Polygon).
std::vector<Loops> voronoi(std::span<const Polygon> regions, const Box& canvas,
                           const VoronoiSites& sites = {});

}  // namespace vitrine::player
