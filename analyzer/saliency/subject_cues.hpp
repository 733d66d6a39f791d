#pragma once

#include "analyzer/saliency/saliency_map.hpp"

#include <vector>

namespace vitrine::analyzer {

/// Maps that tell a photograph's subject from its surroundings, each CV_32FC1 of one size (at most 160 px),
/// between 0.01 (no sign of it) and about 1.2. All are flat where the picture is.
struct SubjectCues {
    cv::Mat enclosed;  // height of the colour barrier to the picture's border
    cv::Mat sharp;     // fine detail: the lens was focused on the subject
    cv::Mat central;   // nearness to the middle of the places of this colour: backgrounds reach all borders
};

/// The cues of a picture.
///
/// @param bgr  CV_8UC3, not empty; its longest side should be about 320 px, for `sharp` is measured there
/// Source: enclosed is the minimum barrier distance (barrier_distance.hpp); central follows the colour
/// spatial distribution of Liu et al., Learning to Detect a Salient Object, 2007.
SubjectCues subject_cues(const cv::Mat& bgr);

}  // namespace vitrine::analyzer
