#pragma once

#include <chrono>

namespace vitrine::player {

/// The way of the view along a panning wall, from which every box of a wall knows where the view is.
struct PanCourse {
    double view = 0;                    // left edge of the view at `since`, ribbon px
    std::chrono::nanoseconds since{0};  // of the leader's wall
    double speed = 0;                   // px a second
    double last = 0;  // ribbon px: the view goes no farther, as the shots there are not ready

    bool operator==(const PanCourse&) const = default;

    /// The left edge of the view at a time of the leader's wall, ribbon px.
    double at(std::chrono::nanoseconds now) const;

    /// The time at which the view's left edge comes to a place, ribbon px. @pre speed > 0
    std::chrono::nanoseconds time_of(double place) const;
};

}  // namespace vitrine::player
