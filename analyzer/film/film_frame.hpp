#pragma once

#include <opencv2/core.hpp>

#include <chrono>
#include <functional>

namespace vitrine::analyzer {

/// One decoded picture as the analysis sees it.
struct FilmFrame {
    cv::Mat picture;                   // CV_8UC3, BGR, upright, square pixels, longest side <= analysis size
    std::chrono::nanoseconds time{0};  // stream time, to which a player can seek; 0 for a photo
    /// Makes the same picture with up to twice as many px a side, to search it for what is small. It keeps
    /// the decoded frame in memory, and the frame's source must outlive it. Null: `picture` has all px that
    /// the source has.
    std::function<cv::Mat()> finer;
};

}  // namespace vitrine::analyzer
