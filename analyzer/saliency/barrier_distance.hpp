#pragma once

#include "analyzer/saliency/saliency_map.hpp"

namespace vitrine::analyzer {

/// The barrier between each pixel and the picture's border: the smallest range of values that any path from
/// the border to the pixel must cross, by three raster scans, summed over the channels.
///
/// @param lab  CV_32FC3, not empty
/// @return     CV_32FC1 of that size, >= 0, in units of the channels; 0 on the border
/// Source: Zhang et al., Minimum Barrier Salient Object Detection at 80 FPS, 2015, algorithm 1 (FastMBD).
cv::Mat barrier_distance(const cv::Mat& lab);

/// The contrast of each pixel to the border's colours: the sum of the Mahalanobis distances to the four
/// border strips without the largest, for the subject may touch one side.
///
/// @param lab  CV_32FC3, not empty
/// @return     CV_32FC1 of that size in [0, 1]
/// Source: Zhang et al. 2015, section 4.1 (the backgroundness cue of MB+).
cv::Mat border_contrast(const cv::Mat& lab);

}  // namespace vitrine::analyzer
