#pragma once

#include "analyzer/saliency/saliency_map.hpp"

#include <vector>

namespace vitrine::analyzer {

/// What may tell a photograph's subject from its surroundings, each CV_32FC1 of one size (at most 160 px),
/// between 0.01 (nothing of it here) and about 1.2. All are flat where the picture is.
struct SubjectCues {
    cv::Mat enclosed;  // by how high a wall of colour it is parted from the picture's border
    cv::Mat sharp;     // how much fine detail is here: the subject is what the lens was focused on
    cv::Mat central;   // how near the middle the places of this colour are: backgrounds reach all borders
};

/// The cues of a picture.
///
/// @param bgr  CV_8UC3, not empty; its longest side should be about 320 px, for `sharp` is measured there
/// Source: enclosed is the minimum barrier distance (barrier_distance.hpp); central follows the colour
/// spatial distribution of Liu et al., Learning to Detect a Salient Object, 2007.
SubjectCues subject_cues(const cv::Mat& bgr);

}  // namespace vitrine::analyzer
