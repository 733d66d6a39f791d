#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The lines that a reader would miss: all but those that are tiny, or far smaller than the largest.
/// @param lines    px of the picture
/// @param picture  px, its size
std::vector<Box> readable_lines(std::span<const Box> lines, Vec2 picture);

/// The page that lines make: a menu, a price list, an announcement. Lines are a page where there are three or
/// more and they fill a good part of what they enclose and of the picture.
/// @return  the hull of the lines; no corners where they are no page
Polygon text_page(std::span<const Box> lines, Vec2 picture);

}  // namespace vitrine::analyzer
