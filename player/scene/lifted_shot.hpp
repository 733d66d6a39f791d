#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>

namespace vitrine::player {

/// The place and the look of a lifted shot at a moment.
struct LiftedPose {
    Placement at;
    double open = 0;   // 0: the outline of its cell, carried along; 1: the whole picture
    double alpha = 1;  // opacity
    double dims = 0;   // share by which the wall behind it is darker

    bool operator==(const LiftedPose&) const = default;
};

/// A shot that is drawn above the wall, because a finger holds it or somebody looks at it. It goes from pose
/// to pose. Knows no clock.
class LiftedShot {
  public:
    /// @param placed  its place on the wall, with its cell; the filler and parts apart of that stay behind
    LiftedShot(const PlacedShot& placed, std::chrono::nanoseconds now);

    /// Begins the way to a pose.
    void aim(const LiftedPose& to, std::chrono::nanoseconds now, std::chrono::nanoseconds duration);

    /// Moves the goal of the way, which takes no longer for that.
    void move_goal(const Placement& to) { to_.at = to; }

    /// Moves the shot at once, such as with a finger. @param way  canvas px
    void follow(Vec2 way);

    LiftedPose pose(std::chrono::nanoseconds now) const;

    const LiftedPose& goal() const { return to_; }

    /// The share of the way that is done, in [0, 1].
    double progress(std::chrono::nanoseconds now) const;

    const PlacedShot& placed() const { return placed_; }

    /// True if its picture is seen at a canvas point.
    bool is_at(Vec2 point, std::chrono::nanoseconds now) const;

    DrawItem drawn(std::chrono::nanoseconds now) const;

  private:
    PlacedShot placed_;  // where it was lifted
    LiftedPose from_;
    LiftedPose to_;
    std::chrono::nanoseconds began_{0};
    std::chrono::nanoseconds duration_{0};
};

/// The part of a shot's picture that is seen when it is seen whole, source px.
Box whole_picture(const WallShot& shot);

/// The placement at which a shot's whole picture is as large as a share of some room on the canvas allows,
/// with its middle at a centre or as near to it as the room allows.
Placement fitting(const WallShot& shot, const Box& room, double share, Vec2 centre);

}  // namespace vitrine::player
