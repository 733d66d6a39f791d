#pragma once

#include "player/layout/cells/voronoi.hpp"
#include "player/layout/layout.hpp"

#include <vector>

namespace vitrine::player {

/// Regions and cores of some items.
struct SharedItems {
    std::vector<Polygon> regions;  // canvas px, convex, disjoint
    std::vector<Loops> cores;      // where each has pixels, in the canvas
};

/// Who shows what of the canvas.
struct Shares {
    std::vector<Loops> shown;   // per item, from its own pixels
    std::vector<Loops> filler;  // per item, where nobody has pixels
};

/// From a point to a convex polygon; 0 inside.
double distance_to(const Polygon& region, Vec2 point);

/// Shares the canvas out among the groups and the items by themselves, then each group's share among its
/// items: every place goes to the nearest region whose item has pixels there. What is small and has not its
/// nearest goes whole to one.
Shares shared_out(const SharedItems& items, const std::vector<LayoutGroup>& groups, const Box& canvas,
                  const VoronoiSites& how);

}  // namespace vitrine::player
