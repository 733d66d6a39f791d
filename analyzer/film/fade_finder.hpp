#pragma once

#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"

#include <optional>

namespace vitrine::analyzer {

/// Finds frames of one colour, black or white, and the fades that lead there and away from there. A fade
/// begins and ends where the picture is lit to three quarters.
class FadeFinder {
  public:
    /// @param since  the transition reaches back no further than this frame
    /// @return       a stretch that is over: a fade; or, where both its sides are abrupt, two cuts in one
    std::optional<Transition> push(const FeatureWindow& window, std::size_t frame, std::size_t since);

    /// The stretch still open at the film's end.
    std::optional<Transition> finish(std::chrono::nanoseconds end);

    std::optional<std::chrono::nanoseconds> open_since() const;

  private:
    Transition closed(const FeatureWindow& window);
    bool is_growing(const FeatureWindow& window, std::size_t frame) const;

    std::optional<Transition> open_;
    bool in_plain_ = false;      // the last frame was of one colour
    std::size_t plain_end_ = 0;  // first frame after the plain ones
};

}  // namespace vitrine::analyzer
