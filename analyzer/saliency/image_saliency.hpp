#pragma once

#include "analyzer/saliency/saliency_map.hpp"

namespace vitrine {

/// What makes a place of a still picture salient.
enum class ImageSaliency {
    frequency_tuned,  // the paper's: contrast to the picture's mean colour
    barrier,          // not connected to the border, unlike the border, near the centre
};

/// How near the centre each place is: 1 there, falling off by a Gaussian of a third of each side.
SaliencyMap centre_prior(cv::Size size);

/// S_I of one picture.
///
/// @param bgr  CV_8UC3, not empty
/// @return     of that size, in [0, 1]; all 0 where `barrier` finds the picture flat
/// Source: Dynamic Media Assemblage 3.2 for frequency_tuned. `barrier` follows MB+ of Zhang et al. 2015,
/// worked at 160 px, with the frequency-tuned map as a third witness: regions of 21 labelled photographs
/// overlap their subjects by .63 instead of .47 (regions_bench with YuNet, "ours" and "tuned, min_area").
SaliencyMap image_saliency(const cv::Mat& bgr, ImageSaliency method);

}  // namespace vitrine
