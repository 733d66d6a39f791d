#pragma once

#include <opencv2/core.hpp>

#include <chrono>

namespace vitrine::analyzer {

/// One decoded picture as the analysis sees it.
struct FilmFrame {
    cv::Mat picture;                   // CV_8UC3, BGR, upright, square pixels, longest side <= analysis size
    std::chrono::nanoseconds time{0};  // stream time, to which a player can seek; 0 for a photo
};

}  // namespace vitrine::analyzer
