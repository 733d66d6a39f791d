#pragma once

#include "analyzer/faces/face_detector.hpp"
#include "analyzer/saliency/saliency_map.hpp"

#include <array>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// Number of facts that judge a window.
constexpr std::size_t window_facts = 37;

/// One rectangle of the picture that may be the box around its subject.
struct SubjectWindow {
    int left = 0;  // in cells of a 12 x 12 grid over the picture; right and bottom exclusive
    int top = 0;
    int right = 0;
    int bottom = 0;
    std::array<float, window_facts> facts{};
};

/// All windows of a picture with their facts: size, place, aspect and touched borders; share of heads and
/// bodies inside; for each cue the share inside and outside, its density inside, and its fall across
/// the window's edge.
///
/// @param bgr    CV_8UC3, not empty; its longest side should be about 320 px
/// @param faces  px of bgr
std::vector<SubjectWindow> subject_windows(const cv::Mat& bgr, std::span<const Face> faces);

/// The likelihood that each place belongs to the picture's subject: every window is weighed by the
/// exponential of a weighted sum of its facts, and each place gets the weights of the windows that hold it.
///
/// The weights are fitted (bench/analysis/fit_windows.py) to the subjects that u2netp finds in a third of the
/// pictures of analyzer/models/student/pictures.tsv, but for the weight of heads, which is given. The
/// likelihood is raised to a power, so that the region may be small.
/// @return  S_I of bgr's size, in [0, 1]; about the middle where the picture is flat
SaliencyMap subject_likelihood(const cv::Mat& bgr, std::span<const Face> faces);

}  // namespace vitrine::analyzer
