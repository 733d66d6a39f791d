#pragma once

#include "player/layout/cells/cells.hpp"

#include <span>

namespace vitrine::player {

/// The part of a cell inside some outlines, its filler included. It has no fade_edges.
Cell inside_part(const Cell& cell, std::span<const Polygon> outlines);

/// The part of a cell that shows own pixels outside of some outlines. It has no filler and no fade_edges.
Cell outside_part(const Cell& cell, std::span<const Polygon> outlines);

/// The same cell without its filler.
Cell without_filler(const Cell& cell);

/// The same cell on another canvas: every point p becomes p * scale + offset.
Cell scaled_cell(const Cell& cell, double scale, Vec2 offset);

}  // namespace vitrine::player
