#pragma once

#include "base/state/tapestry.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_keyframes.hpp"

#include <vector>

namespace vitrine::analyzer {

/// Two levels of bricks as they are, not retargeted: 2.5 and 4.5 bricks wide.
struct DrawnLevels {
    static constexpr int finer_keyframes = 8;

    /// @param stripe_steps  grey levels by which the stripes of each keyframe differ
    explicit DrawnLevels(cv::Size one_brick = {120, 50}, int stripe_steps = 0)
        : brick(one_brick), stripes(stripe_steps) {
        tapestry.duration = std::chrono::seconds(finer_keyframes);
        tapestry.height = 2 * brick.height;
        tapestry.tile_width = 128;
        tapestry.brick_width = brick.width;
        std::vector<int> all;
        all.reserve(finer_keyframes);
        for (int k = 0; k < finer_keyframes; ++k)
            all.push_back(k);
        coarse = strip_of(kept);
        fine = strip_of(all);
        tapestry.levels = {{.width = coarse.cols, .keyframes = times(kept)},
                           {.width = fine.cols, .keyframes = times(all)}};
    }

    cv::Mat strip_of(const std::vector<int>& keyframes) const {
        const Brickwork brickwork{.keyframes = static_cast<int>(keyframes.size()), .brick = brick};
        cv::Mat strip(brickwork.height(), brickwork.width(), CV_8UC3, cv::Scalar::all(128));
        for (int k = 0; k < brickwork.keyframes; ++k)
            picture(keyframes[static_cast<std::size_t>(k)]).copyTo(strip(brickwork.place(k)));
        return strip;
    }

    cv::Mat picture(int keyframe) const {
        cv::Mat picture = drawn_keyframe(brick, static_cast<unsigned>(keyframe)).picture;
        for (int x = 0; x < picture.cols; x += 6)
            picture.colRange(x, x + 3) += cv::Scalar::all(stripes);
        return picture;
    }

    static std::vector<std::chrono::nanoseconds> times(const std::vector<int>& keyframes) {
        std::vector<std::chrono::nanoseconds> times;
        times.reserve(keyframes.size());
        for (const int k : keyframes)
            times.push_back(std::chrono::seconds(k) + std::chrono::milliseconds(500));
        return times;
    }

    const cv::Size brick;
    const int stripes;
    const std::vector<int> kept{0, 3, 4, 7};  // places in the finer level: each stays in its row
    Tapestry tapestry;
    cv::Mat coarse;
    cv::Mat fine;
};

}  // namespace vitrine::analyzer
