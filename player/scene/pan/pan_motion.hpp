#pragma once

#include "player/input/gesture.hpp"

#include <chrono>
#include <cstdint>
#include <optional>

namespace vitrine::player {

/// The motion of a view along a panning wall: by itself, with a finger that drags it, and for a while after
/// the finger has flung it. Knows no clock.
class PanMotion {
  public:
    /// @param speed  by itself, px a second
    explicit PanMotion(double speed) : speed_(speed) {}

    /// A paused view moves with a finger only.
    void set_paused(bool is_paused) { is_paused_ = is_paused; }

    /// Follows the drag of one finger; those of others are ignored meanwhile.
    void handle_gesture(const Gesture& gesture);

    /// The way since the last call, px; to the right if positive.
    double next_way(std::chrono::nanoseconds now);

    /// Ends what a finger began.
    void stop();

    /// True while a finger moves the view, or has flung it.
    bool is_in_hand() const { return touch_ != 0 || flung_ != 0; }

    /// The speed by itself at present, px a second.
    double own_speed() const { return is_paused_ || is_in_hand() ? 0 : speed_; }

    /// True until a while after the last drag: the view may go back soon.
    bool may_go_back(std::chrono::nanoseconds now) const;

  private:
    double speed_;
    bool is_paused_ = false;
    std::uint64_t touch_ = 0;  // of the finger that drags; 0: none
    double dragged_ = 0;       // way of the finger since the last call, px
    double flung_ = 0;         // speed left by a finger, px a second
    std::optional<std::chrono::nanoseconds> last_;
    std::optional<std::chrono::nanoseconds> last_drag_;
};

}  // namespace vitrine::player
