#pragma once

#include "player/scene/frame.hpp"

namespace vitrine::player {

/// The walls of opened folders at one moment.
struct OpenedFrames {
    const Frame& top;                  // of the wall on top
    const Frame& outer;                // of the wall behind it
    const Frame* outermost = nullptr;  // of the wall behind that; null: there is none
    Box mark;                          // of the way back on the wall on top, canvas px
    Box outer_mark;                    // the same on the wall behind
    Box box;                           // of the folder on the wall behind, canvas px
    double share = 1;                  // of the way from the wall behind to the one on top; clamped to [0, 1]
};

/// The frame of opened folders: a wall on its way into another, with the ways back.
Frame opened_frame(const OpenedFrames& walls);

}  // namespace vitrine::player
