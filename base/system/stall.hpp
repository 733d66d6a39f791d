#pragma once

#include <chrono>

namespace vitrine {

/// Tells work that hangs from slow work: work hangs if this process computes next to nothing for the time
/// given to the constructor.
class Stall {
  public:
    using Duration = std::chrono::nanoseconds;

    explicit Stall(Duration patience) : patience_(patience) {}

    /// Tells if the work hangs. Ask about once a second while you wait for it.
    ///
    /// @param now   time of a steady clock
    /// @param busy  processor time that this process has used so far
    bool is_hanging(Duration now, Duration busy);

    /// Tells if the work hangs, by this process' clocks.
    bool is_hanging();

  private:
    Duration patience_;
    Duration since_{-1};  // time at which it last computed
    Duration busy_{};     // processor time at that time
};

}  // namespace vitrine
