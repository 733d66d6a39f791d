#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/vec2.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// What one sampled frame of a film, or a photo, says. Everything is in px of the map.
struct Sample {
    std::chrono::nanoseconds time{0};
    std::chrono::nanoseconds pair_time{0};  // of the frame before, that motion was measured against
    SaliencyMap motion;                     // S_M; empty where there was no frame before
    Vec2 global_motion;                     // per second
    Vec2 subject_motion;                    // per second, of what is salient, in the picture
    SaliencyMap image;                      // S_I
    std::vector<Face> faces;                // found in this frame or, between two searches, in an earlier one
    std::chrono::nanoseconds faces_time{0};  // of the frame they were found in
    cv::Mat picture;                         // the frame itself, BGR, only where someone observes
};

/// Longest side of the maps kept of each sample, px.
constexpr int map_side = 160;

/// Searches one frame.
///
/// @param frame     CV_8UC3, not empty
/// @param before    the frame directly before it; empty at the start
/// @param seconds   between the two, > 0
/// @param settings  frame_size, motion and, where there is no stage, image are used
/// @param faces     px of the maps, those known
/// @param stage     finds what is salient in the picture itself
/// @return          maps of at most map_side; times, faces and picture are left to the caller
Sample searched(const cv::Mat& frame, const cv::Mat& before, double seconds, const AnalysisSettings& settings,
                std::span<const Face> faces = {}, ImageSaliencyStage* stage = nullptr);

/// The faces in px of the maps that searched() makes of such a frame.
std::vector<Face> searched_faces(FaceDetector& detector, const cv::Mat& frame, bool only_prominent);

/// The size of the maps of a frame.
cv::Size map_size(cv::Size frame);

}  // namespace vitrine::analyzer
