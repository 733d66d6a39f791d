#include "analyzer/saliency/salient_volume.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr double min_common_part = 0.6;  // share of each side
constexpr double max_carry = 0.25;       // share of the picture's longer side, from a look to a frame
constexpr double min_step = 0.5;         // px between two places that are drawn

/// The way of the salient part from one frame to another, px of the picture.
Vec2 way_between(std::span<const SalientFrame> frames, std::size_t from, std::size_t to) {
    Vec2 way;
    for (std::size_t i = std::min(from, to); i < std::max(from, to); ++i) {
        const double time = frames[i + 1].time - frames[i].time;
        way = way + (frames[i].subject_motion + frames[i + 1].subject_motion) * (time / 2);
    }
    return from < to ? way : way * -1;
}

/// The frame nearest in time that the network has looked at. @pre there is one
std::size_t nearest_look(std::span<const SalientFrame> frames, double time) {
    std::size_t nearest = frames.size();
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames[i].subject.empty()) continue;
        if (nearest == frames.size() ||
            std::abs(frames[i].time - time) < std::abs(frames[nearest].time - time))
            nearest = i;
    }
    return nearest;
}

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

SaliencyMap subject_volume(std::span<const SalientFrame> frames, Vec2 drift) {
    const auto has_subject = [](const SalientFrame& frame) { return !frame.subject.empty(); };
    if (std::none_of(frames.begin(), frames.end(), has_subject)) return {};
    SaliencyMap largest;
    cv::Mat moved;
    std::size_t last_look = frames.size();
    Vec2 last_shift;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::size_t look = nearest_look(frames, frames[i].time);
        const cv::Mat& map = frames[look].subject;
        const Vec2 way = way_between(frames, look, i);
        if (length(way) > max_carry * std::max(map.cols, map.rows)) continue;  // flow that is lost
        const Vec2 shift = drift * frames[i].time - way;
        if (look == last_look && length(shift - last_shift) < min_step) continue;
        last_look = look;
        last_shift = shift;
        const cv::Matx23d place(1, 0, shift.x, 0, 1, shift.y);
        cv::warpAffine(map, moved, place, map.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                       cv::BORDER_CONSTANT, 0);
        if (largest.empty())
            largest = moved.clone();
        else
            cv::max(largest, moved, largest);
    }
    return largest;
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
