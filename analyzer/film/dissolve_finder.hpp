#pragma once

#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"

#include <optional>

namespace vitrine::analyzer {

/// Says if a frame is in a dissolve of two or three frames, which looks like a cut. Frames up to four later
/// must be known.
bool is_in_short_dissolve(const FeatureWindow& window, std::size_t frame);

/// Finds dissolves: stretches in which the picture goes in a straight line from one picture to an unlike one.
///
/// For frames s..e with signatures f, D = f_e - f_s and a_t = <f_t - f_s, D> / |D|^2 must grow evenly from 0
/// to 1 while hardly anything is left beside D. A pan grows evenly as well, but between alike pictures: hence
/// the test of the normalised cross-correlation of both ends. Windows of several lengths end at each frame;
/// those that overlap are one dissolve. TransitionDetector checks if motion explains the change after all.
class DissolveFinder {
  public:
    /// Looks at the windows that end with `frame`.
    /// @param since  no window may begin before this frame: the last transition
    /// @return       a dissolve that is over for good
    std::optional<Transition> push(const FeatureWindow& window, std::size_t frame, std::size_t since);

    /// The dissolve still open.
    std::optional<Transition> finish();

    /// The begin of the open dissolve.
    std::optional<std::chrono::nanoseconds> open_since() const;

  private:
    std::optional<Transition> open_;
};

}  // namespace vitrine::analyzer
