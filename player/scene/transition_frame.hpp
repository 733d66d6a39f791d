#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/transition.hpp"

#include <chrono>

namespace vitrine::player {

/// The frame of a transition at a time.
///
/// Below, opaque, are the shots that move, each at its present place, and those that leave; above, at one
/// opacity, the same shots that move and those that come. Each layer shares the canvas out as a wall does. In
/// a gap that no shot of the lower layer has pixels for one sees the old wall, and what comes where a shot
/// that moves was. In a gap of the upper layer one sees what comes, and the lower layer where a shot that
/// moves will be. Photos that drift come back to their places and begin their new ways, without a jump at the
/// begin and at the end.
/// @param passed  time since the transition's begin
Frame transition_frame(const Transition& transition, std::chrono::nanoseconds passed, const CellStyle& style,
                       std::chrono::nanoseconds now);

}  // namespace vitrine::player
