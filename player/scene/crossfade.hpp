#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::player {

// All crossfades: from a wall to the next, of the first wall over the idle picture, and between a wall and a
// tapestry.

/// The opacity of what seems opaque: below an opaque item the renderer may leave others out.
inline constexpr double max_blended = 0.999;

/// Eases a progress in [0, 1] in and out; clamps.
double eased(double progress);

/// The frame of a wall that does not change. A wall without shots is the idle picture. Cells above the others
/// are a little less than opaque; they are to be drawn last. Where the wall leaves a border free, the idle
/// picture is below it.
/// @param view  canvas point at the top left, px
Frame standing_frame(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds now,
                     Vec2 view = {});

/// True if a wall leaves a border of a box free: it was laid out for a smaller canvas.
bool leaves_border(std::span<const PlacedShot> wall, const Box& seen);

/// A frame of the crossfade from one wall to the next: the old wall opaque and the new one over it, or one of
/// them alone. A wall without shots is the idle picture. A shot that is the same in both is drawn only once.
///
/// @param progress  0: only the old wall, 1: only the new one
Frame crossfade(Vec2 canvas, std::span<const PlacedShot> old_wall, std::span<const PlacedShot> new_wall,
                double progress, std::chrono::nanoseconds now);

/// A frame in which each shot of the first wall fades in over the idle picture, from the time at which the
/// shot appeared.
/// @param duration  time in which a shot fades in
Frame fade_in_each(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds duration,
                   std::chrono::nanoseconds now);

/// The frame that fades out while another one fades in.
struct LeavingFrame {
    std::vector<DrawItem> items = {};
    double idle = 1;  // opacity of the idle picture below
};

/// Fades a whole frame in over the previous one, whose items fade out.
/// @param progress   0: only the previous frame, 1: only the new one
/// @param last_part  of the fade: in it the items fade out. Smaller than 1: they stay until they are hardly
///                   seen, so that the idle picture does not shine through, where the new frame covers all
void fade_in(Frame& frame, const LeavingFrame& before, double progress, double last_part = 1);

}  // namespace vitrine::player
