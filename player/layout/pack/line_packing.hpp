#pragma once

#include "player/layout/pack/shape.hpp"

#include <vector>

namespace vitrine::player {

/// Packs all shapes in lines, in their reading order. Chooses the number of lines that needs the smallest
/// screen.
/// @param ratio  width / height of the screen
/// @return       centroids in px, free of overlap, in the order of ReadingOrder
std::vector<Vec2> packed_in_lines(const ScaledShapes& shapes, double ratio);

}  // namespace vitrine::player
