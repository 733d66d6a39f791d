#pragma once

#include <chrono>

namespace vitrine::link {

/// The pauses between tries to reach the broker: each is twice the one before.
class Backoff {
  public:
    using Duration = std::chrono::milliseconds;

    static constexpr Duration first{500};
    static constexpr Duration longest{30'000};
    static constexpr Duration held{10'000};  // a connection that held so long was a good one

    /// The pause before the next try.
    /// @param connected  how long the last connection held; 0: there was none
    Duration next(Duration connected);

  private:
    Duration pause_ = first;
};

}  // namespace vitrine::link
