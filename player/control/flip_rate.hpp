#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

namespace vitrine::player {

/// Flips a second of the first screen, between the last two reports.
class FlipRate {
  public:
    /// @param flips  of the first screen so far; a screen that is new counts from 0 again
    void report(std::uint64_t flips, std::chrono::nanoseconds now) {
        const double seconds = std::chrono::duration<double>(now - std::exchange(reported_, now)).count();
        const std::uint64_t before = std::exchange(flips_, flips);
        rate_ = seconds > 0 && flips >= before ? static_cast<double>(flips - before) / seconds : 0;
    }

    double rate() const { return rate_; }

  private:
    std::chrono::nanoseconds reported_{0};  // time of the last report
    std::uint64_t flips_ = 0;
    double rate_ = 0;
};

}  // namespace vitrine::player
