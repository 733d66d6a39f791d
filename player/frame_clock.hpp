#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace vitrine::player {

/// When the pictures of a steady rate are due, and how many came too late. Knows no clock: `now` is passed
/// in, since the player's start.
class FrameClock {
  public:
    explicit FrameClock(int rate) : rate_(rate) {}

    /// When the next picture is due.
    std::chrono::nanoseconds due() const { return due_of(index_); }

    /// The next picture has been shown. Pictures whose time is over by then are left out and count as late.
    void shown(std::chrono::nanoseconds now);

    /// The next picture has been shown at its own time, however long it took.
    void shown_exactly() { ++index_; }

    /// Nothing was to be shown until now: what was due meanwhile is not late.
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
