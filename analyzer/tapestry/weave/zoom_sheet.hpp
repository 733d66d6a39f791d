#pragma once

#include "analyzer/tapestry/weave/strip_zoom.hpp"

namespace vitrine::analyzer {

/// The zoom between two levels where the finer one adds most: the coarser level, a quarter, half and three
/// quarters of the way with one fading into the other, the same moments bent and synthesised, the finer
/// level.
///
/// @param rules  one more than rules.between is a multiple of 4
cv::Mat drawn_zoom(const LevelPair& pair, const RunTasks& run, const ZoomRules& rules = {});

}  // namespace vitrine::analyzer
