#pragma once

#include <chrono>

namespace vitrine::player {

/// Lets something happen at most once in an interval, whoever asks.
class RateLimit {
  public:
    explicit RateLimit(std::chrono::nanoseconds interval) : interval_(interval) {}

    /// @param now  never goes back
    /// @return  true: it may happen now, and counts as having happened
    bool take_turn(std::chrono::nanoseconds now) {
        if (now < next_) return false;
        next_ = now + interval_;
        return true;
    }

  private:
    std::chrono::nanoseconds interval_;
    std::chrono::nanoseconds next_ = std::chrono::nanoseconds::min();
};

}  // namespace vitrine::player
