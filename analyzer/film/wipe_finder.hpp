#pragma once

#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"

#include <array>
#include <optional>
#include <vector>

namespace vitrine::analyzer {

/// Finds wipes: an edge that runs evenly over the whole picture and leaves another picture behind.
///
/// Each place of the picture changes most when the edge passes it. In a wipe these times lie in one plane
/// over the picture, t = a x + b y + c, or for a circle in a cone, whatever moves in either shot. A thing
/// that passes close by runs over the picture as well, but leaves the same picture behind; a pan is explained
/// by motion.
class WipeFinder {
  public:
    /// Looks at the windows that are due with `frame`.
    /// @param since  no wipe may begin before this frame: the last transition
    std::optional<Transition> push(const FeatureWindow& window, std::size_t frame, std::size_t since);

  private:
    static constexpr std::size_t windows = 4;
    struct Passing;

    static std::vector<Passing> passings(const FeatureWindow& window, std::size_t first, std::size_t last);
    static std::optional<Transition> passed(const FeatureWindow& window, std::size_t first, std::size_t last,
                                            double since, double duration);
    static std::optional<Transition> wipe_in(const FeatureWindow& window, std::size_t first,
                                             std::size_t last);

    std::array<std::chrono::nanoseconds, windows> due_{};  // time of the next look at each window
};

}  // namespace vitrine::analyzer
