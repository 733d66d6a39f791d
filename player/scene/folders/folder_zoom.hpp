#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <span>
#include <string>

namespace vitrine::player {

/// The largest box of the canvas' shape inside the cells of a folder's shots: the wall of the opened folder
/// grows out of it. Canvas px. A folder that is not on the wall has a small box in the middle.
Box box_of_folder(std::span<const PlacedShot> wall, const std::string& folder, Vec2 canvas);

/// A frame on the way from a wall to that of one of its folders. All of the outer wall becomes larger about
/// one point, until the box is the canvas. The inner wall lies in the box and fades in over the folder's
/// shots. So the canvas is covered at any time, and only the folder's own shots are covered by the inner
/// wall.
/// @param box       of the folder, px of the outer canvas; both walls have the same canvas
/// @param progress  0: only the outer wall, 1: only the inner one
Frame zoom_frame(const Frame& outer, const Frame& inner, const Box& box, double progress);

/// The place of the inner wall's canvas on the screen on that way.
Placement inner_placement(Vec2 canvas, const Box& box, double progress);

/// The same frame on another canvas: every point p becomes p * to.scale + to.offset. Items outside the canvas
/// are left out.
Frame placed_frame(const Frame& frame, const Placement& to);

}  // namespace vitrine::player
