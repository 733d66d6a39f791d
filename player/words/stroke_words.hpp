#pragma once

#include "base/geometry/vec2.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// A straight stroke of a pen.
using Stroke = std::array<Vec2, 2>;

/// A line of text as strokes, for the names of outputs and for numbers: A to Z, digits, "-", "." and ",".
/// Small letters are drawn as capitals, all else as a box. Capitals are 1 high; the line begins at (0, 0).
std::vector<Stroke> strokes_of(std::string_view text);

/// The length of a line of text whose capitals are 1 high.
double stroke_length(std::string_view text);

}  // namespace vitrine::player
