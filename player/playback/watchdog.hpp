#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// Watches over one film that plays: drivers and files have been seen to stop in silence. Knows no clock.
class Watchdog {
  public:
    enum class Verdict { fine, rebuild, rebuild_in_software, give_up };

    /// To be called with every picture shown. After a rebuild the next is not judged before it had its time.
    /// @param is_starved  nothing is there to be shown next
    Verdict judge(bool is_starved, std::chrono::nanoseconds now);

  private:
    std::optional<std::chrono::nanoseconds> starved_;  // since when
    std::optional<std::chrono::nanoseconds> fine_;     // since when, after a rebuild
    int rebuilds_ = 0;
};

}  // namespace vitrine::player
