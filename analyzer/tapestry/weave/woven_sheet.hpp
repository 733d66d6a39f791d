#pragma once

#include "analyzer/tapestry/weave/film_weave.hpp"

namespace vitrine::analyzer {

/// Draws the levels below each other, each around the middle of the one above. Lines lead from the begin and
/// the end of each level's part to the same times in the level above. Source: Video Tapestries, figure 6.
cv::Mat drawn_weave(const Film& film, const std::vector<Keyframes>& levels, const RetargetSettings& settings,
                    const RunTasks& run);

}  // namespace vitrine::analyzer
