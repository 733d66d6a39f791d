#pragma once

#include "player/layout/layout.hpp"

#include <array>
#include <span>

namespace vitrine {

/// What an item shows of the canvas. All canvas px, counter-clockwise.
struct Cell {
    std::vector<Polygon> parts;  // shown from the item's own pixels; parts[0] holds the I-Region
    std::vector<Polygon>
        filler;  // nobody has pixels here: drawn from a darkened mirror of the item's picture
    std::vector<std::array<Vec2, 3>> triangles;         // `parts`, cut up for the renderer
    std::vector<std::array<Vec2, 3>> filler_triangles;  // `filler`, cut up
};

/// How cells are drawn up. All canvas px.
struct CellStyle {
    double gutter =
        0;  // width of the gap between cells, which then belongs to none; the canvas' edge has none
    double sample_spacing = 0;  // between sites on the outlines, the paper's way; 0: exact outlines. Sampled
                                // sites may erode I-Regions
    double sample_inset = 2;    // that sampled sites lie inside the outline
};

/// Shares the whole canvas out: every point goes to the item whose I-Region is nearest among those whose
/// core has pixels there, else to the nearest as filler. The cells of one layout cover the canvas exactly
/// once, and each holds its I-Region whole (where that is inside the canvas).
/// Source: Dynamic Media Assemblage 3.5. Differs: exact Voronoi diagram of the outlines, not sampled sites.
/// @pre the I-Regions do not overlap
std::vector<Cell> cells(std::span<const LayoutItem> items, const Layout& layout, const CellStyle& style = {});

}  // namespace vitrine
