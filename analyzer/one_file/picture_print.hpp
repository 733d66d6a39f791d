#pragma once

#include "base/state/picture_print.hpp"

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The print of a photo within its bars. Its sharpness is the variance of the Laplacian.
/// @param bgr  CV_8UC3, not empty
PicturePrint print_of(const cv::Mat& bgr);

}  // namespace vitrine::analyzer
