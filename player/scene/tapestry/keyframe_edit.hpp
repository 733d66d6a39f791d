#pragma once

#include "base/hints/keyframe_choice.hpp"

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A technician's choice of a film's keyframes, changed by touches while its tapestry is shown. Knows no
/// clock.
class KeyframeEdit {
  public:
    /// @param choice  the choice so far
    explicit KeyframeEdit(KeyframeChoice choice) : choice_(std::move(choice)) {}

    const KeyframeChoice& choice() const { return choice_; }

    /// Strikes a picture of the strip. One that was chosen is chosen no more; one that is struck is no longer
    /// struck.
    void touch_picture(std::chrono::nanoseconds keyframe);

    /// Makes this moment a keyframe, in the place of chosen and struck ones beside it.
    void choose(std::chrono::nanoseconds moment);

    /// Takes back what was chosen and struck beside this moment.
    void take_back(std::chrono::nanoseconds moment);

    /// The choice, if it has changed since the last call.
    std::optional<KeyframeChoice> take_changed();

  private:
    bool forget(std::vector<std::chrono::nanoseconds>& moments, std::chrono::nanoseconds beside);
    void add(std::vector<std::chrono::nanoseconds>& moments, std::chrono::nanoseconds moment);

    KeyframeChoice choice_;
    bool has_changed_ = false;
};

}  // namespace vitrine::player
