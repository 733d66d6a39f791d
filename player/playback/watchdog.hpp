#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// Watches over one film that plays: drivers and files have been seen to stop without an error. Knows no
/// clock.
class Watchdog {
  public:
    enum class Verdict { fine, rebuild, rebuild_in_software, give_up };

    /// Judges the film; to be called with every frame. A film that was rebuilt gets its time before the next
    /// verdict.
    /// @param is_starved  no picture is there to be shown next
    Verdict judge(bool is_starved, std::chrono::nanoseconds now);

  private:
    std::optional<std::chrono::nanoseconds> starved_;  // the begin of starving
    std::optional<std::chrono::nanoseconds> fine_;     // the begin of a time without starving
    int rebuilds_ = 0;
};

}  // namespace vitrine::player
