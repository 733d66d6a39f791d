#pragma once

#include "player/layout/layout.hpp"

#include <array>
#include <span>

namespace vitrine::player {

/// An outline along which a cell fades out over its neighbours.
struct FadeEdge {
    Polygon outline;             // with corners close enough that the widths change evenly between them
    std::vector<double> widths;  // canvas px, one a corner: reach of the cell beyond it
};

/// The part of the canvas that an item shows. All canvas px, counter-clockwise.
struct Cell {
    std::vector<Polygon> parts;   // shown from the item's own pixels; parts[0] holds the I-Region
    std::vector<Polygon> filler;  // no item has pixels here: a darkened mirror of this item's picture
    std::vector<std::array<Vec2, 3>> triangles;         // `parts`, cut up for the renderer
    std::vector<std::array<Vec2, 3>> filler_triangles;  // `filler`, cut up
    std::vector<FadeEdge> fade_edges;                   // edges of `parts`; none: as narrow as a pixel
    double edge_coverage = 0.5;  // opacity on the outline itself; 1: nothing lies on the other side
};

/// The style of the cells. All canvas px.
struct CellStyle {
    double gutter = 0;  // width of the gap between cells, which belongs to none; none at the canvas' edge
    double corner_radius = 0;   // rounds the cells' corners; corners of I-Regions are never cut
    double feather = 1;         // width in which neighbours fade into each other, where no I-Region is
    double sample_spacing = 0;  // distance of sites on the outlines, the paper's way; 0: exact outlines.
                                // Sampled sites may erode I-Regions
    double sample_inset = 2;    // depth of sampled sites inside the outline
};

/// Shares the whole canvas out: every point goes to the item whose I-Region is nearest among the items whose
/// core has pixels there, else to the nearest as filler. The cells of one layout cover the canvas exactly
/// once, and each holds its I-Region whole (where it is inside the canvas). Gutters and cut corners belong
/// to no cell. A group shares out its own cell alone.
/// Source: Dynamic Media Assemblage 3.5. Differs: exact Voronoi diagram of the outlines, not sampled sites.
/// @pre the I-Regions do not overlap
std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style = {});

}  // namespace vitrine::player
