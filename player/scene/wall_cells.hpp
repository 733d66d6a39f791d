#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/scene/wall_shot.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// Gives each shot its cell in a layout of only these shots. Shots of one group form one cell group.
void give_cells(std::vector<PlacedShot>& wall, Vec2 canvas, const CellStyle& style);

/// The share of the canvas on which no I-Region is seen, plus the share on which no shot has pixels.
/// @pre each shot has a cell
double wasted_share(std::span<const PlacedShot> wall, Vec2 canvas);

/// The same shots and cells in another size and place. @param offset  canvas px, after scaling
std::vector<PlacedShot> transformed(std::vector<PlacedShot> wall, double scale, Vec2 offset);

/// The bounds of all that is drawn in a cell, canvas px.
Box bounds_of(const Cell& cell);

/// True if the shot's cell contains this canvas point.
bool is_at(const PlacedShot& placed, Vec2 point);

}  // namespace vitrine::player
