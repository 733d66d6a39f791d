#pragma once

#include <chrono>

namespace vitrine {

/// Tells work that hangs from work on a slow machine: it hangs where for so long next to nothing was
/// computed.
class Stall {
  public:
    using Duration = std::chrono::nanoseconds;

    explicit Stall(Duration longest) : longest_(longest) {}

    /// To be asked about once a second while something is waited for.
    ///
    /// @param now   of a clock that goes on
    /// @param busy  processor time that this process has used so far
    bool has_come(Duration now, Duration busy);

    /// The same, by this process' clocks.
    bool has_come();

  private:
    Duration longest_;
    Duration since_{-1};  // when it last computed
    Duration busy_{};     // by then
};

}  // namespace vitrine
