#pragma once

#include "player/layout/layout.hpp"

namespace vitrine::player {

/// The part of the canvas in which a cell may show an item: the item's core. A side that is less than a pixel
/// from the canvas' edge counts as on it, as the outermost pixels are repeated there.
inline Box shown_frame(const LayoutItem& item, const Placement& at, Vec2 canvas) {
    Box frame = placed_core(item, at);
    if (frame.min.x > 0 && frame.min.x < 1) frame.min.x = 0;
    if (frame.min.y > 0 && frame.min.y < 1) frame.min.y = 0;
    if (frame.max.x < canvas.x && frame.max.x > canvas.x - 1) frame.max.x = canvas.x;
    if (frame.max.y < canvas.y && frame.max.y > canvas.y - 1) frame.max.y = canvas.y;
    return frame;
}

}  // namespace vitrine::player
