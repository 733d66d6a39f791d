#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The names of the folders on a wall. Each stands at the largest place for a line of text that lies inside
/// the cells of the folder's shots and touches no I-Region of the wall. A folder without room for letters
/// that can be read has none. Canvas px.
/// @param taken  a box that stays free, too
std::vector<FrameName> folder_names(std::span<const PlacedShot> wall, Vec2 canvas, const Box& taken);

}  // namespace vitrine::player
