#pragma once

#include "base/geometry/vec2.hpp"
#include "base/state/zoom_field.hpp"

#include <cstdint>
#include <vector>

namespace vitrine::player {

/// A tile on its way between two levels: drawn at any moment from where its points are in both.
struct ZoomMesh {
    struct Vertex {
        float coarse_x = 0;  // in the coarser level, px from `coarse_origin`
        float coarse_y = 0;
        float fine_x = 0;  // in the finer one, px from `fine_origin`
        float fine_y = 0;
        float u = 0;  // of the tile's picture, [0, 1]
        float v = 0;
        float growth = 0;  // px of the coarser strip a px of the finer one; < 0: it is drawn whole
    };

    std::vector<Vertex> vertices;
    std::vector<std::uint16_t> triangles;  // triples of vertices
    bool is_whole = false;                 // nothing of it lets through what is below
    double coarse_origin = 0;              // px of the coarser strip
    double fine_origin = 0;
    double coarse_left = 0;  // px of the strip between which all of it lies
    double coarse_right = 0;
    double fine_left = 0;
    double fine_right = 0;
};

/// @param left          where the tile begins, px of its strip
/// @param is_to_finer   it is of the coarser level, and drawn whole; else of the finer one, which is drawn
/// over
///                      it: everywhere as much of it as it has of the width by then
ZoomMesh zoom_mesh(const ZoomField& field, double left, bool is_to_finer);

/// How much of a finer level's tile is seen over the coarser one's where it has this growth, in [0, 1]. What
/// both show goes over evenly; what is new, and came out of nothing, is all that there is to be seen.
/// @param share  of the way from the coarser level to the finer one
double zoom_coverage(double growth, double share);

}  // namespace vitrine::player
