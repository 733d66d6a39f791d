#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/carve.hpp"

namespace vitrine::analyzer {

/// Cuts a tile as wide as its target out of its window, and sets what the loss of each pixel costs. When a
/// row is lost, the rows around it are seen a row off: the loss counts the mean of the squared steps down
/// there. Pixels of faces and regions cost more, so that they stay whole.
///
/// @param width  px; where the window ends earlier, its last column fills the rest
CarveInput carve_input(const BrickWindow& window, int width);

/// Finds the rows that the finished columns of a target show, and writes them to CarveInput::given. In each
/// column it is the cheapest way down.
///
/// @param known    CV_8UC3, the target's size
/// @param columns  CV_8UC1, one row: not 0 where a column is known
/// Source: the hard constraint of Video Tapestries 4.2. Ours: it is met before the first round.
void give_rows(CarveInput& input, const cv::Mat& known, const cv::Mat& columns);

}  // namespace vitrine::analyzer
