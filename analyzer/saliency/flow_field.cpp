#include "analyzer/saliency/flow_field.hpp"

#include <opencv2/video/tracking.hpp>

#include <algorithm>

namespace vitrine::analyzer {
namespace {

constexpr int tracked_step = 8;        // px between tracked points
constexpr int window = 11;             // px a side of the patches compared
constexpr double reliable_error = 20;  // mean absolute difference of patches, grey levels
constexpr double min_texture = 1e-3;   // smallest eigenvalue for which Lucas-Kanade has an answer
constexpr int dense_cell = 2;          // px, the finest that the search gives
constexpr int large = 120;             // px wide, from which on half the size is fine enough
constexpr float reach = 4;             // px, half a patch of the dense search

}  // namespace

FlowField tracked_flow(const cv::Mat& before, const cv::Mat& after) {
    FlowField flow{.grid = {before.cols / tracked_step, before.rows / tracked_step},
                   .cell = tracked_step,
                   .vectors = {},
                   .is_reliable = {}};
    std::vector<cv::Point2f> from;
    for (int i = 0; i < flow.grid.area(); ++i) {
        const Vec2 place = flow.place(static_cast<std::size_t>(i));
        from.emplace_back(cv::Point2d(place.x, place.y));
    }
    std::vector<cv::Point2f> to;
    std::vector<unsigned char> found;
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(before, after, from, to, found, error, {window, window}, 3,
                             {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 10, 0.03}, 0, min_texture);
    const cv::Rect2f picture(0, 0, static_cast<float>(before.cols), static_cast<float>(before.rows));
    for (std::size_t i = 0; i < from.size(); ++i) {
        const cv::Point2f d = to[i] - from[i];
        flow.vectors.push_back({static_cast<double>(d.x), static_cast<double>(d.y)});
        flow.is_reliable.push_back(found[i] != 0 && to[i].inside(picture) &&
                                   static_cast<double>(error[i]) < reliable_error);
    }
    return flow;
}

FlowField dense_flow(const cv::Mat& before, const cv::Mat& after) {
    const cv::Ptr<cv::DISOpticalFlow> search =
        cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_ULTRAFAST);
    search->setFinestScale(before.cols >= large ? 1 : 0);
    cv::Mat dense;
    search->calc(before, after, dense);
    FlowField flow{.grid = {before.cols / dense_cell, before.rows / dense_cell},
                   .cell = dense_cell,
                   .vectors = {},
                   .is_reliable = {}};
    const cv::Rect2f whole_patches(reach, reach, static_cast<float>(before.cols) - 2 * reach,
                                   static_cast<float>(before.rows) - 2 * reach);
    flow.vectors.reserve(static_cast<std::size_t>(flow.grid.area()));
    for (int y = 0; y < flow.grid.height; ++y) {
        const auto* upper = dense.ptr<cv::Point2f>(y * dense_cell);
        const auto* lower = dense.ptr<cv::Point2f>(y * dense_cell + 1);
        for (int x = 0; x < flow.grid.width; ++x) {
            const int c = x * dense_cell;
            const cv::Point2f v = 0.25F * (upper[c] + upper[c + 1] + lower[c] + lower[c + 1]);
            const cv::Point2f from(static_cast<float>(c + 1), static_cast<float>(y * dense_cell + 1));
            flow.vectors.push_back({static_cast<double>(v.x), static_cast<double>(v.y)});
            flow.is_reliable.push_back(from.inside(whole_patches) && (from + v).inside(whole_patches));
        }
    }
    return flow;
}

}  // namespace vitrine::analyzer
