#pragma once

#include "player/layout/cells/voronoi.hpp"
#include "player/layout/layout.hpp"

#include <vector>

namespace vitrine::player {

/// The regions and cores of items that share a canvas.
struct ItemAreas {
    std::vector<Polygon> regions;  // canvas px, convex, disjoint
    std::vector<Loops> cores;      // parts of the canvas where each has pixels
};

/// The parts of the canvas that each item shows.
struct CanvasShares {
    std::vector<Loops> shown;   // one an item, shown from its own pixels
    std::vector<Loops> filler;  // one an item, where no item has pixels
};

/// The distance from a point to a convex polygon; 0 inside.
double distance_to(const Polygon& region, Vec2 point);

/// Shares the canvas out among the groups and the items without a group, then each group's share among its
/// items: every place goes to the nearest region whose item has pixels there. A small area whose nearest
/// item has no pixels there goes whole to one other.
CanvasShares share_canvas(const ItemAreas& items, const std::vector<LayoutGroup>& groups, const Box& canvas,
                          const VoronoiSites& how);

}  // namespace vitrine::player
