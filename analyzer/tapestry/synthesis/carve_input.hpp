#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"
#include "analyzer/tapestry/synthesis/carve.hpp"

namespace vitrine::analyzer {

/// A tile as wide as its target, cut out of its window, with what carving needs to know of it: that of the
/// rows around a lost one each is seen a row off, so that the mean of the squared steps down there is lost
/// too, and that faces are to stay whole.
///
/// @param width  px; what the window lacks on the right is filled with its last column
CarveInput carve_input(const BrickWindow& window, int width);

/// Which of their rows those columns of a target show that are made already, found column by column as the
/// cheapest way down; written to CarveInput::given.
///
/// @param known    CV_8UC3, the target's size
/// @param columns  CV_8UC1, one row: not 0 where a column is known
/// Source: the hard constraint of Video Tapestries 4.2. Ours: it is met before the first round.
void give_rows(CarveInput& input, const cv::Mat& known, const cv::Mat& columns);

}  // namespace vitrine::analyzer
