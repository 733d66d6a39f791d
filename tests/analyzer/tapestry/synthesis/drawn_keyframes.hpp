#pragma once

#include "analyzer/tapestry/synthesis/brickwork.hpp"

#include <opencv2/imgproc.hpp>

#include <random>

namespace vitrine::analyzer {

/// A picture of some soft shapes on a gradient, the same for the same seed.
inline Keyframe drawn_keyframe(cv::Size size, unsigned seed) {
    std::mt19937 random(seed);
    const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    // Compilers evaluate arguments in different orders, so each number has a line of its own.
    const auto colour = [&](int below) {
        const int red = any(below);
        const int green = any(below);
        const int blue = any(below);
        return cv::Scalar(blue, green, red);
    };
    cv::Mat picture(size, CV_8UC3);
    const cv::Scalar sky = colour(200);
    for (int y = 0; y < size.height; ++y)
        picture.row(y).setTo(sky + cv::Scalar::all(50.0 * y / size.height));
    for (int i = 0; i < 5; ++i) {
        const cv::Scalar fill = colour(256);
        const int radius = 2 + any(size.height / 4);
        const int x = any(size.width);
        const int y = any(size.height);
        cv::circle(picture, {x, y}, radius, fill, cv::FILLED, cv::LINE_AA);
    }
    return {.picture = picture, .faces = {}};
}

inline std::vector<Keyframe> drawn_keyframes(const Brickwork& brickwork) {
    std::vector<Keyframe> keyframes;
    keyframes.reserve(static_cast<std::size_t>(brickwork.bricks()));
    for (int i = 0; i < brickwork.bricks(); ++i)
        keyframes.push_back(drawn_keyframe(brickwork.brick, static_cast<unsigned>(i)));
    return keyframes;
}

}  // namespace vitrine::analyzer
