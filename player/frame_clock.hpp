#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace vitrine::player {

/// Tells when each frame of a steady rate is due, and counts late frames. Knows no clock: `now` is passed in,
/// since the player's start.
class FrameClock {
  public:
    explicit FrameClock(int rate) : rate_(rate) {}

    /// The time at which the next frame is due.
    std::chrono::nanoseconds due() const { return due_of(index_); }

    /// The time at which the frame of this moment was due.
    std::chrono::nanoseconds last_due(std::chrono::nanoseconds now) const {
        return due_of(index_after(now) - 1);
    }

    /// Call when the next frame has been shown. Frames whose time is over are left out and count as late.
    void advance(std::chrono::nanoseconds now);

    /// Call when the next frame has been shown at its own time, however long it took.
    void advance_exactly() { ++index_; }

    /// Call while there was no picture to show: the frames until now are not late.
    void skip_to(std::chrono::nanoseconds now);

    std::int64_t pictures() const { return index_ - skipped_ - late_; }

    std::int64_t late() const { return late_; }

  private:
    std::chrono::nanoseconds due_of(std::int64_t index) const {
        return std::chrono::nanoseconds(index * std::int64_t{1'000'000'000} / rate_);
    }

    std::int64_t index_after(std::chrono::nanoseconds now) const;

    int rate_;
    std::int64_t index_ = 0;
    std::int64_t late_ = 0;
    std::int64_t skipped_ = 0;
};

}  // namespace vitrine::player
