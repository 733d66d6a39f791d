#pragma once

#include "analyzer/saliency/saliency_map.hpp"

namespace vitrine::analyzer {

/// A BGR picture in CIE L*a*b* of its true scale: CV_32FC3, L in [0, 100], a and b about [-128, 127].
/// (OpenCV's 8-bit Lab stretches L by 2.55, which lets brightness drown colour.)
cv::Mat lab(const cv::Mat& bgr);

/// Frequency-tuned saliency: the distance of a pixel's slightly blurred colour from the picture's mean
/// colour.
///
/// @param lab  CV_32FC3 of lab(), not empty
/// @return     S_I of the same size; divided by its maximum, or by 10 where no pixel is that far (a flat
///             picture is not salient because of its noise)
/// Source: Achanta et al. 2009, as Dynamic Media Assemblage 3.2 [1]: |mean of Lab - 5x5 binomial of Lab|.
SaliencyMap frequency_tuned(const cv::Mat& lab);

}  // namespace vitrine::analyzer
