#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/transition.hpp"

#include <chrono>

namespace vitrine::player {

/// The frame of a transition at a time.
///
/// Below, opaque, are the shots that move, each at its present place, and those that leave; above, at one
/// opacity, the same shots that move and those that come. Each layer shares the canvas out as a wall does. A
/// gap that no shot of the lower layer has pixels for shows what is there on the old wall. One of the upper
/// layer shows what comes there; where a shot that moves will be, the lower layer is seen. Photos that drift
/// come back to their places and begin their new ways, without a jump at the begin and at the end.
/// @param passed  time since the transition's begin
Frame transition_frame(const Transition& transition, std::chrono::nanoseconds passed, const CellStyle& style,
                       std::chrono::nanoseconds now);

}  // namespace vitrine::player
