#include "analyzer/saliency/salient_volume.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr double min_common_part = 0.6;  // share of each side

}  // namespace

SaliencyMap accumulated(std::span<const SalientFrame> frames, Vec2 drift) {
    SaliencyMap sum = SaliencyMap::zeros(frames.front().map.size(), CV_32FC1);
    cv::Mat moved;
    for (const SalientFrame& frame : frames) {
        const Vec2 shift = drift * frame.time;
        if (shift == Vec2{}) {
            sum += frame.map;
            continue;
        }
        const cv::Matx23d place(1, 0, shift.x, 0, 1, shift.y);
        cv::warpAffine(frame.map, moved, place, sum.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                       cv::BORDER_CONSTANT, 0);
        sum += moved;
    }
    return sum;
}

Box common_part(cv::Size frame, Vec2 drift, double duration) {
    const Vec2 travel = drift * duration;
    return {{std::max(0.0, -travel.x), std::max(0.0, -travel.y)},
            {frame.width - std::max(0.0, travel.x), frame.height - std::max(0.0, travel.y)}};
}

Vec2 limited_drift(cv::Size frame, Vec2 drift, double duration) {
    if (duration <= 0) return {};
    const double scale_x = (1 - min_common_part) * frame.width / (std::abs(drift.x) * duration + 1e-9);
    const double scale_y = (1 - min_common_part) * frame.height / (std::abs(drift.y) * duration + 1e-9);
    return drift * std::min({1.0, scale_x, scale_y});
}

}  // namespace vitrine::analyzer
