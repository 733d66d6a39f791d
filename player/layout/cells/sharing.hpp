#pragma once

#include "player/layout/cells/voronoi.hpp"
#include "player/layout/layout.hpp"

#include <vector>

namespace vitrine::player {

/// The regions and cores of the items on one canvas.
struct ItemAreas {
    std::vector<Polygon> regions;  // canvas px, convex, disjoint
    std::vector<Loops> cores;      // the parts of the canvas where each item has pixels
};

/// The part of the canvas for each item.
struct CanvasShares {
    std::vector<Loops> shown;   // one for each item; shows the item's own pixels
    std::vector<Loops> filler;  // one for each item; no item has pixels there
};

/// The distance from a point to a convex polygon; 0 inside.
double distance_to(const Polygon& region, Vec2 point);

/// Divides the canvas among the groups and the items without a group, then each group's share among its
/// items. Every place goes to the nearest region whose item has pixels there. A small area whose nearest item
/// has no pixels there goes to one other item as a whole. Where no item of a group has pixels, items outside
/// that group come in.
CanvasShares share_canvas(const ItemAreas& items, const std::vector<LayoutGroup>& groups, const Box& canvas,
                          const VoronoiSites& how);

}  // namespace vitrine::player
