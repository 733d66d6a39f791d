#pragma once

#include <chrono>
#include <cstdint>

namespace vitrine::player {

/// The rate of a screen's flips between the last two notes. Knows no clock: the time is passed in.
class FlipRate {
  public:
    /// @param flips  of the screen so far; fewer than at the last note: it is another screen
    void note(std::uint64_t flips, std::chrono::nanoseconds now) {
        const double seconds = std::chrono::duration<double>(now - noted_).count();
        rate_ = seconds > 0 && flips >= flips_ ? static_cast<double>(flips - flips_) / seconds : 0;
        flips_ = flips;
        noted_ = now;
    }

    /// Flips a second.
    double rate() const { return rate_; }

  private:
    std::uint64_t flips_ = 0;
    std::chrono::nanoseconds noted_{0};
    double rate_ = 0;
};

}  // namespace vitrine::player
