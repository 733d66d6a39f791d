#pragma once

#include "base/geometry/box.hpp"

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

// The parts of a picture that other programs would keep if they may keep a given share of its area. All keep
// the picture's aspect; boxes are px of the picture.

/// The middle.
Box centre_crop(cv::Size size, double share);

/// libvips: vips_smartcrop with its "attention" strategy.
/// @throws std::runtime_error if libvips fails
Box attention_crop(const cv::Mat& bgr, double share);

/// smartcrop.js as its author describes it, written anew: edges, skin and saturation are found, and among all
/// places in steps of 8 px the crop is chosen in which they weigh most; its middle and thirds count more,
/// its rim and what is left outside count against it. Without its optional face boosts.
Box smartcrop_crop(const cv::Mat& bgr, double share);

}  // namespace vitrine::analyzer
