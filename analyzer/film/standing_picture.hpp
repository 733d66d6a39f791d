#pragma once

#include "analyzer/film/feature_window.hpp"
#include "analyzer/film/transition.hpp"

namespace vitrine::analyzer {

/// The part of a transition that may still count to the shot beside it: a share of all that changes on the way.
struct StandingShare {
    static constexpr double fade = .25;  // a picture so much darker still shows all there is
    static constexpr double dissolve = .12;
};

/// One past the last frame that still shows the picture of `first`: from there on to `last` the picture changes.
/// @param first, last  frames that the window knows, first <= last
std::size_t stands_until(const FeatureWindow& window, std::size_t first, std::size_t last, double share);

/// The first frame that shows the picture of `last` already.
std::size_t stands_from(const FeatureWindow& window, std::size_t first, std::size_t last, double share);

/// The transition without the frames at both ends in which the picture stands. A dissolve to or from a picture
/// of one colour is a fade.
Transition without_standing(const FeatureWindow& window, const Transition& dissolve);

}  // namespace vitrine::analyzer
