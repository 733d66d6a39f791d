#pragma once

#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::player {

/// The way that a shot can be moved in this direction: its I-Region stays in its cell, and its cell within
/// its picture. Canvas px; 0: not at all.
/// @param direction  of length 1
/// @pre the shot has a cell that contains its I-Region
double free_way(const PlacedShot& placed, Vec2 direction);

/// Gives each photo the longest way inside its cell, within limits.
/// @param before  the wall before; a photo keeps its direction from there if that is nearly as long
/// @param bands   canvas px; no I-Region drifts under one
void give_drifts(std::span<PlacedShot> wall, std::span<const PlacedShot> before,
                 std::span<const Box> bands = {});

/// Where a photo is on its way, relative to the place of its layout, canvas px. A function of time alone:
/// smooth, and different for each photo.
Vec2 drift_at(const PlacedShot& placed, std::chrono::nanoseconds now);

/// The same, not further than the shot's present cell allows.
/// @param share  of the way, in [0, 1]
Vec2 drift_within_cell(const PlacedShot& placed, const PhotoDrift& way, double share,
                       std::chrono::nanoseconds now);

}  // namespace vitrine::player
