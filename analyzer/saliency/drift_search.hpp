#pragma once

#include "analyzer/saliency/salient_volume.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The frames thinned and made smaller for the search, in their own pixels.
struct SearchSpace {
    std::vector<SalientFrame> frames;
    double duration = 0;
    double mass = 0;
    double scale = 1;  // search px per map px

    /// The share of the picture that the most salient half takes once accumulated along a drift in search px;
    /// saliency outside the common part is lost.
    double area(Vec2 drift) const;
};

/// The search space of a shot: each map less its median, which leaves the subject's part, for a background
/// that lies everywhere concentrates nowhere. @pre frames is not empty
SearchSpace search_space(std::span<const SalientFrame> frames, double duration);

/// The drift, in search px, with the smallest area of all that leave enough in common: on a coarse grid, then
/// on a finer one around the best.
Vec2 searched_drift(const SearchSpace& space);

}  // namespace vitrine::analyzer
