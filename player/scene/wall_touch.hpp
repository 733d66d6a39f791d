#pragma once

#include "player/input/gesture.hpp"
#include "player/layout/edit/wall_state.hpp"
#include "player/scene/drag.hpp"
#include "player/scene/enlargement.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A small change of the wall that follows a touch.
struct TouchedWall {
    std::vector<PlacedShot> wall;                  // with outdated cells
    std::optional<std::chrono::nanoseconds> pace;  // duration of the change; none: the usual one
};

/// A shot that was flicked out of the canvas.
struct DismissedShot {
    SourceId source = 0;
    int slot = 0;
    Seat seat;         // the place that it had
    TouchedWall rest;  // the wall without it
};

/// Visitors' touches on the shots of a wall: they drag, enlarge or dismiss a shot (docs/technician.md,
/// "Touch").
class WallTouch {
  public:
    /// @param idle  time after which a tapped shot returns
    WallTouch(const EditRules& rules, std::chrono::nanoseconds idle)
        : drag_(rules), enlargement_(rules, idle) {}

    /// @param wall  the present wall, with cells
    void handle_gesture(const Gesture& gesture, std::span<const PlacedShot> wall, Vec2 canvas);

    /// Ends the enlargement, because the wall has changed otherwise.
    void end_enlargement() { enlargement_.end(); }

    /// True while a finger moves a shot, a shot is large, or one is being dismissed.
    bool is_active() const { return drag_.is_active() || enlargement_.is_on() || dismissed_ != 0; }

    /// Removes and returns the dismissed shot. None: nobody has flicked a shot that is on the wall.
    std::optional<DismissedShot> take_dismissed(std::span<const PlacedShot> wall);

    /// The next small change of the wall. None: nothing moves.
    std::optional<TouchedWall> next_wall(std::span<const PlacedShot> wall, Vec2 canvas,
                                         std::chrono::nanoseconds now);

  private:
    Drag drag_;
    Enlargement enlargement_;
    SourceId dismissed_ = 0;  // 0: none
};

}  // namespace vitrine::player
