#pragma once

#include "analyzer/tapestry/weave/strip_zoom.hpp"

namespace vitrine::analyzer {

/// Draws the zoom between two levels where the finer one adds most. The rows are: the coarser level; a
/// quarter, half and three quarters of the way with one level fading into the other; the same moments bent;
/// the same moments synthesised; the finer level.
///
/// @param rules  rules.between + 1 is a multiple of 4
cv::Mat drawn_zoom(const LevelPair& pair, const RunTasks& run, const ZoomRules& rules = {});

}  // namespace vitrine::analyzer
