#pragma once

#include <chrono>
#include <optional>

namespace vitrine::player {

/// Time between the begins of two changes. Each change lets a place become brighter and darker once at most,
/// so no place does that more than twice in a second, as WCAG 2.3.1 asks.
constexpr std::chrono::nanoseconds flash_spacing = std::chrono::milliseconds(500);

/// The same with `show.calm`.
constexpr std::chrono::nanoseconds calm_spacing = std::chrono::seconds(5);

/// Holds changes back that would come too soon after the last one.
class ChangePace {
  public:
    /// @param spacing  least time between the begins of two changes
    explicit ChangePace(std::chrono::nanoseconds spacing) : spacing_(spacing) {}

    bool is_calm() const { return spacing_ >= calm_spacing; }

    bool is_free(std::chrono::nanoseconds now) const { return !last_ || now - *last_ >= spacing_; }

    void note_change(std::chrono::nanoseconds now) { last_ = now; }

  private:
    std::chrono::nanoseconds spacing_;
    std::optional<std::chrono::nanoseconds> last_;  // begin of the last change; none: there was none
};

}  // namespace vitrine::player
