#pragma once

#include "analyzer/film/shot_detector.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace vitrine::analyzer {

inline const cv::Size scene_size(160, 90);
inline constexpr std::chrono::milliseconds frame_time{40};

/// Coarse coloured noise, so that two seeds give unlike pictures and one seed always the same.
inline cv::Mat scene(int seed, const cv::Scalar& tint, const cv::Size& size = scene_size) {
    cv::RNG random(static_cast<std::uint64_t>(seed));
    cv::Mat coarse(9 * size.height / scene_size.height, 16 * size.width / scene_size.width, CV_8UC3);
    random.fill(coarse, cv::RNG::UNIFORM, 0, 120);
    cv::Mat picture;
    cv::resize(coarse, picture, size, 0, 0, cv::INTER_CUBIC);
    return picture + tint;
}

inline cv::Mat warm() {
    return scene(1, {20, 60, 130});
}

inline cv::Mat cold() {
    return scene(2, {130, 60, 20});
}

inline cv::Mat black() {
    return cv::Mat::zeros(scene_size, CV_8UC3);
}

inline cv::Mat mixed(const cv::Mat& from, const cv::Mat& to, double share) {
    cv::Mat out;
    cv::addWeighted(from, 1 - share, to, share, 0, out);
    return out;
}

/// The place of frame i in a transition of frames [begin, end): 0 before, 1 after.
inline double progress(int i, int begin, int end) {
    return std::clamp((i - begin + 1.0) / (end - begin + 1.0), 0.0, 1.0);
}

using Drawing = std::function<cv::Mat(int)>;
using Timing = std::function<std::chrono::nanoseconds(int)>;

inline std::vector<DetectedShot> shots_of(int frames, const Drawing& draw, const Timing& time) {
    ShotDetector detector;
    std::vector<DetectedShot> shots;
    for (int i = 0; i < frames; ++i)
        std::ranges::copy(detector.push({.picture = draw(i), .time = time(i)}), std::back_inserter(shots));
    std::ranges::copy(detector.finish(time(frames)), std::back_inserter(shots));
    return shots;
}

inline std::vector<DetectedShot> shots_of(int frames, const Drawing& draw) {
    return shots_of(frames, draw, [](int i) { return i * frame_time; });
}

inline DetectedShot shot(int first, int end, ShotEnd ends_with) {
    return {first * frame_time, end * frame_time, ends_with};
}

inline bool is_near(std::chrono::nanoseconds time, int frame, int tolerance) {
    return std::chrono::abs(time - frame * frame_time) <= tolerance * frame_time;
}

}  // namespace vitrine::analyzer
