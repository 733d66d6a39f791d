#pragma once

#include "player/layout/cells/cells.hpp"

#include <vector>

namespace vitrine::player {

/// A cell cut up for the graphics card. Besides the triangles that fill it there are
/// - its outline as a strip, drawn below everything: where a corner of one cell meets the middle of another's
///   side, rounding may leave a pixel to neither, and that pixel then shows the strip and not the background;
/// - a fringe, a strip outside along its outline whose coverage falls from half to nothing: each cell's lies
///   on its neighbour, which smooths the seam for the price of the seam's pixels, not of the picture's.
struct CellMesh {
    struct Vertex {
        float x = 0;  // canvas px
        float y = 0;
        float coverage = 1;
    };

    /// A range of the vertices.
    struct Range {
        int first = 0;
        int count = 0;
    };

    /// The vertices of the cell's parts, or those of its filler.
    struct Layer {
        Range outline;    // triples
        Range triangles;  // triples
        Range fringe;     // triples
    };

    std::vector<Vertex> vertices;
    Layer parts;
    Layer filler;
};

/// @param fringe  width of the fringe at edges without fade_edges, canvas px, >= 0
CellMesh cell_mesh(const Cell& cell, double fringe);

}  // namespace vitrine::player
