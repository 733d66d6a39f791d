#pragma once

#include <opencv2/core.hpp>

#include <chrono>
#include <functional>

namespace vitrine::analyzer {

/// One decoded picture as the analysis sees it.
struct FilmFrame {
    cv::Mat picture;                   // CV_8UC3, BGR, upright, square pixels, longest side <= analysis size
    std::chrono::nanoseconds time{0};  // stream time, to which a player can seek; 0 for a photo
    /// Makes the same picture with up to twice as many px a side, for what is small in a film's frame. Keeps
    /// the decoded frame; the frame's source must live. Null: the picture is the finest there is.
    std::function<cv::Mat()> finer;
};

}  // namespace vitrine::analyzer
