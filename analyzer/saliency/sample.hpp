#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/picture_kind.hpp"
#include "analyzer/saliency/saliency_map.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/words/line_detector.hpp"
#include "base/geometry/vec2.hpp"
#include "base/state/shot_look.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The findings in one sampled frame of a film, or in a photo. Everything is in px of the map.
struct Sample {
    std::chrono::nanoseconds time{0};
    std::chrono::nanoseconds pair_time{0};  // time of the frame before, against which motion was measured
    SaliencyMap motion;                     // S_M; empty where there was no frame before
    Vec2 global_motion;                     // per second
    Vec2 subject_motion;                    // per second, motion of the salient part
    SaliencyMap image;                      // S_I
    SaliencyMap subject;                    // found by the network; empty where it was not asked
    std::vector<Face> faces;                // found in this frame or, between two searches, in an earlier one
    std::chrono::nanoseconds faces_time{0};  // time of the frame they were found in
    std::vector<Box> lines;                  // of text, found in this frame or in an earlier one
    std::chrono::nanoseconds lines_time{0};  // time of the frame they were found in
    PictureLook look;                        // of a film's frame
    ShotLook signature;                      // of the picture within its bars
    double changed_share = 0;                // of the picture, since the sample before
    cv::Mat picture;                         // the frame itself, BGR; empty unless an observer wants it
    cv::Mat glance;  // of a film: the picture within its bars as a network wants it; empty: not kept
    cv::Rect seen;   // px of the map: its place
};

/// Longest side of the maps of a sample, px.
constexpr int map_side = 160;

/// A frame and the frame directly before it.
struct FramePair {
    cv::Mat frame;       // CV_8UC3, not empty
    cv::Mat before;      // the frame before, equally large; empty at the start
    double seconds = 1;  // from one to the other, > 0
    cv::Rect active{};   // px of the frame: the picture within its bars; empty: all of it
};

/// Searches one frame.
///
/// @param settings  frame_size, motion and, where there is no stage, image are used
/// @param faces     px of the maps, as far as they are known
/// @param stage     finds the saliency of the picture itself
/// @return          maps of at most map_side, 0 in the bars; times, faces and picture are left to the caller
Sample sample_of(const FramePair& pair, const AnalysisSettings& settings, std::span<const Face> faces = {},
                 ImageSaliencyStage* stage = nullptr);

/// The subject of a frame's picture within its bars, in px of the maps, as a network sees it.
/// @throws std::runtime_error like SaliencyNetwork::map()
SaliencyMap find_subject(SaliencyNetwork& network, const FramePair& pair);

/// Keeps what subject_in() needs of a frame's picture within its bars, in the size of a quick look.
void keep_glance(Sample& sample, const FramePair& pair);

/// The subject of a sample that was kept so, in px of the maps.
/// @pre sample.glance is not empty
/// @throws std::runtime_error like SaliencyNetwork::map()
SaliencyMap subject_in(SaliencyNetwork& network, const Sample& sample);

/// The look of a frame's picture within its bars, in px of the maps.
PictureLook look_within(const cv::Mat& frame, const cv::Rect& active);

/// The faces of a frame, in px of the maps that sample_of() makes of it.
std::vector<Face> find_faces(FaceDetector& detector, const cv::Mat& frame, bool only_prominent);

/// Adds the faces that are too small to be found in a film's frame. It leaves out large faces that only the
/// finer picture has, as most of them are animals'.
/// @param faces  found in the frame, px of the maps
/// @param finer  the same picture with more px
void add_small_faces(std::vector<Face>& faces, FaceDetector& detector, const cv::Mat& finer,
                     bool only_prominent);

/// The lines of text in a frame's picture within its bars, in px of the maps, as far as a reader would miss
/// them. @throws std::runtime_error like LineDetector::find()
std::vector<Box> find_lines(LineDetector& detector, const FramePair& pair);

/// The size of the maps of a frame.
cv::Size map_size(cv::Size frame);

/// A part of a frame in px of its maps, at least one pixel large.
cv::Rect map_part(const cv::Rect& part, cv::Size frame);

}  // namespace vitrine::analyzer
