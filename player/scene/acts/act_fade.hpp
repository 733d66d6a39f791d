#pragma once

#include "player/scene/crossfade.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <optional>
#include <vector>

namespace vitrine::player {

/// The way from what a box has shown to an act that goes on elsewhere: what was shown fades out, and its
/// films play on meanwhile. It ends as soon as the canvas becomes another one. Knows no clock.
class ActFade {
  public:
    /// Lets the last frame fade out. On another canvas the idle picture is beside it.
    /// @param view   of the frames to come: canvas point at the top left, px
    /// @param place  of the canvas so far on that of the frames to come
    void begin(Vec2 view, const Placement& place, std::chrono::nanoseconds now);

    /// Draws what fades out into the next frame, and keeps this.
    void draw(Frame& frame, std::chrono::nanoseconds now);

    /// The items that fade out.
    const std::vector<DrawItem>& items() const { return before_.items; }

  private:
    LeavingFrame last_;                              // the last frame
    Vec2 last_view_;                                 // canvas point at its top left
    Vec2 last_canvas_;                               // its canvas, px
    LeavingFrame before_;                            // what fades out
    std::optional<std::chrono::nanoseconds> since_;  // none: nothing fades out
    std::optional<Vec2> canvas_;                     // on which it fades out, px; none: not drawn so far
};

}  // namespace vitrine::player
