#pragma once

#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"

namespace vitrine::analyzer {

/// One past the last frame that still shows the picture of `first`: from there on to `last` the picture
/// changes. A fade's picture stands while it is lit to three quarters, however it moves.
/// @param first, last  frames that the window knows, first <= last
/// @param kind         fade, or any other
std::size_t stands_until(const FeatureWindow& window, std::size_t first, std::size_t last, ShotEnd kind);

/// The first frame that shows the picture of `last` already.
std::size_t stands_from(const FeatureWindow& window, std::size_t first, std::size_t last, ShotEnd kind);

/// The transition without the frames at both ends in which the picture stands. A dissolve to or from a
/// picture of one colour is a fade.
Transition without_standing(const FeatureWindow& window, const Transition& dissolve);

}  // namespace vitrine::analyzer
