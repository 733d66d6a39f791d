#pragma once

#include "base/media/colour.hpp"

#include <gst/video/video.h>
#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The raw formats reduce_frame() reads; others are converted to one of them first.
constexpr const char* reducible_formats = "{ I420, YV12, Y42B, Y444, NV12, GRAY8, I420_10LE, I422_10LE, "
                                          "Y444_10LE, I420_12LE, I422_12LE, Y444_12LE, A420, A420_10LE, "
                                          "A422_10LE, A444_10LE }";

/// Makes a decoded frame small and converts it to BGR with the film's own colour matrix and range.
///
/// Every plane is first averaged over whole blocks, then resampled by less than a factor of two; colours are
/// converted at the small size only. A 1280 x 720 frame costs a twentieth of its decoding.
///
/// @param frame       mapped for reading, of one of reducible_formats
/// @param size        px, not larger than the frame in either direction
/// @param background  colour that shows through where the frame is transparent
/// @return            CV_8UC3, BGR
cv::Mat reduce_frame(const GstVideoFrame& frame, cv::Size size, Colour background = {});

}  // namespace vitrine::analyzer
