#pragma once

#include "analyzer/saliency/flow_field.hpp"
#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/vec2.hpp"

namespace vitrine::analyzer {

constexpr double strong_motion = 0.5;  // S_M of what moves by itself

/// The way in which motion contrast is measured.
enum class MotionMethod {
    voted_pan,   // the paper's: |v - g| over its largest value, g one motion for the whole picture
    background,  // against pan, zoom and roll, fitted from the voted pan on, less the noise
};

/// The motion against the camera between two pictures.
struct MotionContrast {
    SaliencyMap map;     // S_M
    Vec2 global_motion;  // px per pair that the background moves, x right, y down
    FlowField flow;      // the whole motion; empty where pictures are too small
};

/// Motion contrast of one picture against an earlier one.
///
/// @param before, after  CV_8UC1 of one size, at least 16 px a side, else nothing moves
/// @return  map of that size. In voted_pan the largest value is always 1 where anything moves at all. In
///          background a contrast below 0.3 % of the diagonal and half the global motion does not reach 1,
///          so that flow noise on a still shot and parallax on a moving one stay near 0
/// Source: Dynamic Media Assemblage 3.2; voted_pan follows it word by word: Lucas-Kanade in which vectors
/// that could not be tracked count 0. Differs in background: dense flow; the floor above; patches that leave
/// the picture are left out; the picture's median contrast is subtracted as noise; zoom and roll are fitted,
/// or every zoom would make the picture's edges salient.
MotionContrast motion_contrast(const cv::Mat& before, const cv::Mat& after,
                               MotionMethod method = MotionMethod::background);

}  // namespace vitrine::analyzer
