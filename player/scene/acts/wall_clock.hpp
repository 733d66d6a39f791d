#pragma once

#include <chrono>

namespace vitrine::player {

/// A reading of a box's clocks at one moment.
struct ClockReading {
    std::chrono::nanoseconds steady{0};  // never set, never back
    std::chrono::nanoseconds real{0};    // since 1970
    bool is_right = false;               // others keep `real` right
};

/// The time that all boxes of a wall share: real time where that is kept right, else this box's own steady
/// time. Small differences are made up slowly, so that nothing jumps; large ones at once, when the wall
/// allows that. Knows no clock itself.
///
/// now() counts from the start, never goes back, and goes ahead by less than a second at once. Its zero is a
/// whole second of shared time, so the frames of all boxes are due at the same times.
class WallClock {
  public:
    explicit WallClock(const ClockReading& start);

    /// @param may_jump  nothing moves now
    void follow(const ClockReading& reading, bool may_jump);

    std::chrono::nanoseconds now() const { return now_; }

    /// Shared time, since 1970, at which now() is 0. Changes when the clock jumps.
    std::chrono::nanoseconds epoch() const { return epoch_; }

    /// Real time minus shared time, as far as it is known.
    std::chrono::nanoseconds difference() const { return difference_; }

    /// True: shared time is real time, but for a difference that is being made up.
    bool is_right() const { return is_right_; }

  private:
    void go_to(std::chrono::nanoseconds shared);

    std::chrono::nanoseconds epoch_{0};
    std::chrono::nanoseconds now_{0};
    std::chrono::nanoseconds steady_{0};
    std::chrono::nanoseconds difference_{0};
    bool is_right_ = false;
};

}  // namespace vitrine::player
