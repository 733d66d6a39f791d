#pragma once

#include "player/layout/layout.hpp"

#include <array>
#include <span>

namespace vitrine::player {

/// An outline along which a cell fades out over its neighbours.
struct Rim {
    Polygon outline;             // with corners close enough for the widths to be even between them
    std::vector<double> widths;  // canvas px, one a corner: how far beyond it the cell may reach
};

/// What an item shows of the canvas. All canvas px, counter-clockwise.
struct Cell {
    std::vector<Polygon> parts;  // shown from the item's own pixels; parts[0] holds the I-Region
    std::vector<Polygon>
        filler;  // nobody has pixels here: drawn from a darkened mirror of the item's picture
    std::vector<std::array<Vec2, 3>> triangles;         // `parts`, cut up for the renderer
    std::vector<std::array<Vec2, 3>> filler_triangles;  // `filler`, cut up
    std::vector<Rim> rims;                              // of `parts`; none: as narrow as a pixel
    double rim_coverage = 0.5;  // on the outline itself; 1: nothing lies on the other side
};

/// How cells are drawn up. All canvas px.
struct CellStyle {
    double gutter =
        0;  // width of the gap between cells, which then belongs to none; the canvas' edge has none
    double corner_radius = 0;  // of the cells' corners; those of I-Regions are never cut
    double feather = 1;  // width in which neighbours fade into each other, as far as no I-Region is there
    double sample_spacing = 0;  // between sites on the outlines, the paper's way; 0: exact outlines. Sampled
                                // sites may erode I-Regions
    double sample_inset = 2;    // that sampled sites lie inside the outline
};

/// Shares the whole canvas out: every point goes to the item whose I-Region is nearest among those whose
/// core has pixels there, else to the nearest as filler. The cells of one layout cover the canvas exactly
/// once, and each holds its I-Region whole (where that is inside the canvas).
/// What the corner radius and gutters take belongs to no cell. A group shares out its own cell alone.
/// Source: Dynamic Media Assemblage 3.5. Differs: exact Voronoi diagram of the outlines, not sampled sites.
/// @pre the I-Regions do not overlap
std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style = {});

}  // namespace vitrine::player
