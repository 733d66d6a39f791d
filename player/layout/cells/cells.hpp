#pragma once

#include "player/layout/layout.hpp"

#include <array>
#include <span>

namespace vitrine::player {

/// An outline along which a cell fades out over its neighbours.
struct FadeEdge {
    Polygon outline;             // its corners are so close that the widths change evenly between them
    std::vector<double> widths;  // canvas px, one for each corner: reach of the cell beyond it
};

/// The part of the canvas that an item shows. All canvas px, counter-clockwise.
struct Cell {
    std::vector<Polygon> parts;   // parts that show the item's own pixels; parts[0] holds the I-Region
    std::vector<Polygon> filler;  // parts where no item has pixels: a darkened mirror of this item's picture
    std::vector<std::array<Vec2, 3>> triangles;         // `parts` as triangles for the renderer
    std::vector<std::array<Vec2, 3>> filler_triangles;  // `filler` as triangles
    std::vector<FadeEdge> fade_edges;  // edges of `parts`; none: the edges are as narrow as a pixel
    double edge_coverage = 0.5;  // opacity on the outline itself; 1: there is no neighbour on the other side
};

/// The style of the cells. All canvas px.
struct CellStyle {
    bool is_taut =
        false;          // borders of two cells are pulled taut between regions; else they lie in the middle
    double gutter = 0;  // width of the gap between cells, which belongs to none; none at the canvas' edge
    double corner_radius = 0;   // radius of the cells' corners; corners of I-Regions are never cut
    double feather = 1;         // width in which neighbours fade into each other outside I-Regions
    double sample_spacing = 0;  // distance of sites on the outlines, as in the paper; 0: exact outlines.
                                // Sampled sites may erode I-Regions
    double sample_inset = 2;    // depth of sampled sites inside the outline
};

/// The item without the edge of its core into which the picture outside bleeds: a bar or the border of a
/// scan. Samplers mix neighbouring pixels, most of all in smaller copies. The I-Region stays whole.
/// @param picture  size of the upright picture, source px
LayoutItem without_bleeding_edge(LayoutItem item, Vec2 picture, const Placement& at);

/// Divides the whole canvas: every point goes to the item with the nearest I-Region, among the items whose
/// core has pixels at the point; without such an item, to the nearest item as filler. A core that ends less
/// than a pixel before the canvas' edge counts as reaching it. The cells of one layout cover the canvas
/// exactly once. Each cell contains its whole I-Region (inside the canvas). Gutters and cut corners belong to
/// no cell. A group divides its own cell among its items. Source: Dynamic Media Assemblage 3.5. Differs:
/// exact Voronoi diagram of the outlines, not sampled sites.
/// @pre the I-Regions do not overlap
std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style = {});

}  // namespace vitrine::player
