#pragma once

#include "base/geometry/vec2.hpp"
#include "base/state/zoom_field.hpp"

#include <cstdint>
#include <vector>

namespace vitrine::player {

/// A tile on its way between two levels. Each point is drawn between its places on both levels.
struct ZoomMesh {
    struct Vertex {
        float coarse_x = 0;  // place on the coarser level, px from `coarse_origin`
        float coarse_y = 0;
        float fine_x = 0;  // place on the finer level, px from `fine_origin`
        float fine_y = 0;
        float u = 0;  // share of the tile's picture, [0, 1]
        float v = 0;
        float growth = 0;  // px of the coarser strip per px of the finer one; < 0: drawn opaque
    };

    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> triangles;  // triples of vertices
    bool is_whole = false;                 // the tile is opaque
    double coarse_origin = 0;              // px of the coarser strip
    double fine_origin = 0;
    double coarse_left = 0;  // px of the strip; left and right bounds of the tile's points
    double coarse_right = 0;
    double fine_left = 0;
    double fine_right = 0;
};

/// @param left          left edge of the tile, px of its strip
/// @param is_to_finer   true: the tile is on the coarser level and opaque; false: it is on the finer level
/// and drawn everywhere over the coarser one; its opacity is its share of the width at that time
ZoomMesh zoom_mesh(const ZoomField& field, double left, bool is_to_finer);

}  // namespace vitrine::player
