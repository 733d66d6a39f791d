#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// Watches one film that plays: drivers and files have been seen to stop without an error. Knows no clock.
class Watchdog {
  public:
    enum class Verdict { fine, rebuild, rebuild_in_software, give_up };

    /// Judges the film. Call with every frame. A rebuilt film gets time before the next verdict.
    /// @param is_starved  the next picture is missing
    Verdict judge(bool is_starved, std::chrono::nanoseconds now);

  private:
    std::optional<std::chrono::nanoseconds> starved_;  // the start of starving
    std::optional<std::chrono::nanoseconds> fine_;     // the start of a time without starving
    int rebuilds_ = 0;
};

}  // namespace vitrine::player
