#include "analyzer/saliency/motion_contrast.hpp"

#include "analyzer/saliency/background_motion.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr double noise_floor = 0.003;  // share of the diagonal, per pair
// Share of the camera's own motion: parallax, lens and a flow that errs in proportion make a steady
// background seem to move against itself.
constexpr double camera_floor = 0.5;
constexpr int min_side = 16;              // px
constexpr int spread = 9;                 // px, side of the box over which differences are averaged
constexpr double noise_share = 1.5;       // times the median difference: smaller ones are noise
constexpr double min_difference = 3;      // grey levels
constexpr double certain_difference = 5;  // grey levels above the noise from which on a motion is certain

/// |v - background| by cell, 0 where the flow has no answer.
cv::Mat contrast_by_cell(const FlowField& flow, const BackgroundMotion& background) {
    cv::Mat contrast = cv::Mat::zeros(flow.grid, CV_32FC1);
    auto* values = contrast.ptr<float>();
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        if (flow.is_reliable[i])
            values[i] = static_cast<float>(length(flow.vectors[i] - background.at(flow.place(i))));
    }
    return contrast;
}

float median(const cv::Mat& map) {
    std::vector<float> all(map.begin<float>(), map.end<float>());
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

/// The contrast without outliers, less its median, which is the flow's noise.
cv::Mat denoised(const cv::Mat& contrast) {
    cv::Mat result;
    cv::medianBlur(contrast, result, 5);
    return cv::max(result - static_cast<double>(median(result)), 0);
}

/// The certainty, from 0 to 1, that a place does not move as the background does: the difference, beyond its
/// noise, of the picture to the one before moved by the background. It corrects the flow where the picture
/// shows nothing to follow.
cv::Mat own_motion_certainty(const cv::Mat& before, const cv::Mat& after,
                             const BackgroundMotion& background) {
    const Vec2 t = background.turn;
    const Vec2 shift = background.at({0, 0});
    const cv::Matx23d place(1 + t.x, -t.y, shift.x, t.y, 1 + t.x, shift.y);
    cv::Mat expected;
    cv::warpAffine(after, expected, place, before.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                   cv::BORDER_REPLICATE);
    cv::Mat difference;
    cv::subtract(expected, before, difference, {}, CV_32F);
    difference = cv::abs(difference - static_cast<double>(median(difference)));
    cv::boxFilter(difference, difference, CV_32F, {spread, spread});
    const double noise = static_cast<double>(median(difference));
    cv::Mat result = (difference - (noise_share * noise + min_difference)) / certain_difference;
    return cv::min(cv::max(result, 0), 1);
}

Vec2 global_motion(const FlowField& flow) {
    std::vector<Vec2> reliable;
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        if (flow.is_reliable[i]) reliable.push_back(flow.vectors[i]);
    }
    return voted_motion(reliable);
}

}  // namespace

MotionContrast motion_contrast(const cv::Mat& before, const cv::Mat& after, MotionMethod method) {
    if (std::min(before.cols, before.rows) < min_side)
        return {SaliencyMap::zeros(before.size(), CV_32FC1), {}, {}};
    const bool is_paper_mode = method == MotionMethod::voted_pan;
    FlowField flow = is_paper_mode ? tracked_flow(before, after) : dense_flow(before, after);
    const Vec2 global = global_motion(flow);
    cv::Mat contrast;
    double floor = std::numeric_limits<double>::min();
    if (is_paper_mode) {
        contrast = contrast_by_cell(flow, {.pan = global, .turn = {}, .centre = {}});
    } else {
        const BackgroundMotion background = fitted_background(flow, global);
        contrast = denoised(contrast_by_cell(flow, background));
        cv::Mat certainty;
        cv::resize(own_motion_certainty(before, after, background), certainty, contrast.size(), 0, 0,
                   cv::INTER_AREA);
        contrast = contrast.mul(certainty);
        floor = noise_floor * std::hypot(before.cols, before.rows) + camera_floor * length(global);
    }
    double fastest = 0;
    cv::minMaxLoc(contrast, nullptr, &fastest);
    SaliencyMap map;
    cv::resize(contrast / std::max(fastest, floor), map, before.size(), 0, 0, cv::INTER_LINEAR);
    return {map, global, std::move(flow)};
}

}  // namespace vitrine::analyzer
