#pragma once

#include <chrono>

namespace vitrine {

/// Tells hanging work from slow work: work hangs if this process uses almost no processor time for the time
/// given to the constructor.
class Stall {
  public:
    using Duration = std::chrono::nanoseconds;

    explicit Stall(Duration patience) : patience_(patience) {}

    /// True if the work hangs. Ask about once a second while you wait for it.
    ///
    /// @param now   time of a steady clock
    /// @param busy  processor time that this process has used so far
    bool is_hanging(Duration now, Duration busy);

    /// True if the work hangs, by this process' clocks.
    bool is_hanging();

  private:
    Duration patience_;
    Duration since_{-1};  // the last time at which processor time was used
    Duration busy_{};     // processor time used until then
};

}  // namespace vitrine
