#include "analyzer/saliency/motion_contrast.hpp"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vitrine {
namespace {

constexpr int magnitude_bins = 32;
constexpr int direction_bins = 16;
constexpr double still = 0.25;         // px: shorter vectors have no direction
constexpr double noise_floor = 0.003;  // of the diagonal, per frame
// Of the camera's own motion: parallax, lens and a flow that errs in proportion make a steady background seem
// to move against itself. Films score alike from .5 to 1 (regions_bench).
constexpr double camera_floor = 0.5;
constexpr int least_side = 16;         // px
constexpr int grid_step = 8;           // px between tracked points
constexpr int window = 11;             // px a side of the patches compared
constexpr double reliable_error = 20;  // mean absolute difference of patches, grey levels
constexpr int refits = 12;
constexpr double explained = 1;         // px: a vector this far off the background counts a quarter
constexpr double least_texture = 1e-3;  // smallest eigenvalue for which Lucas-Kanade has an answer

struct Bin {
    int magnitude = 0;  // 0: still, whatever the direction
    int direction = 0;
};

Bin bin_of(Vec2 v, double step) {
    const double magnitude = length(v);
    if (magnitude < still) return {};
    const double turn = std::atan2(v.y, v.x) / (2 * std::numbers::pi) + 0.5;
    const int direction = static_cast<int>(turn * direction_bins) % direction_bins;
    return {std::clamp(1 + static_cast<int>((magnitude - still) / step), 1, magnitude_bins - 1), direction};
}

/// Whether b is a or touches it; directions wrap, and all directions touch the still bin.
bool are_neighbours(Bin a, Bin b) {
    if (std::abs(a.magnitude - b.magnitude) > 1) return false;
    if (a.magnitude == 0 || b.magnitude == 0) return true;
    const int turn = std::abs(a.direction - b.direction);
    return std::min(turn, direction_bins - turn) <= 1;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Bin winning_bin(std::span<const Bin> bins) {
    std::array<std::array<int, direction_bins>, magnitude_bins> votes{};
    for (const Bin bin : bins)
        ++votes[static_cast<std::size_t>(bin.magnitude)][static_cast<std::size_t>(bin.direction)];
    Bin best;
    int most = -1;
    for (int m = 0; m < magnitude_bins; ++m) {
        for (int d = 0; d < (m == 0 ? 1 : direction_bins); ++d) {
            int sum = 0;
            for (int k = std::max(0, m - 1); k <= std::min(m + 1, magnitude_bins - 1); ++k) {
                for (int e = 0; e < direction_bins; ++e) {
                    if (are_neighbours({m, d}, {k, e})) {
                        sum += votes[static_cast<std::size_t>(k)][static_cast<std::size_t>(e)];
                    }
                }
            }
            if (sum > most) {
                most = sum;
                best = {m, d};
            }
        }
    }
    return best;
}

/// The tracked points of one frame pair, row by row.
struct Flow {
    cv::Size grid;
    std::vector<Vec2> vectors;
    std::vector<bool> is_reliable;
};

Flow tracked_grid(const cv::Mat& before, const cv::Mat& after, MotionMethod method) {
    Flow flow{.grid = {before.cols / grid_step, before.rows / grid_step}, .vectors = {}, .is_reliable = {}};
    std::vector<cv::Point2f> from;
    for (int y = 0; y < flow.grid.height; ++y) {
        for (int x = 0; x < flow.grid.width; ++x) {
            from.emplace_back((static_cast<float>(x) + 0.5F) * grid_step,
                              (static_cast<float>(y) + 0.5F) * grid_step);
        }
    }
    std::vector<cv::Point2f> to;
    std::vector<unsigned char> found;
    // A patch that leaves the picture, before or after, is compared with what is not there.
    const float reach = method == MotionMethod::background ? window / 2.0F : 0.0F;
    const cv::Rect2f whole_patches(reach, reach, static_cast<float>(before.cols) - 2 * reach,
                                   static_cast<float>(before.rows) - 2 * reach);
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(before, after, from, to, found, error, {window, window}, 3,
                             {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 10, 0.03}, 0, least_texture);
    for (std::size_t i = 0; i < from.size(); ++i) {
        const cv::Point2f d = to[i] - from[i];
        flow.vectors.push_back({static_cast<double>(d.x), static_cast<double>(d.y)});
        const bool is_seen = from[i].inside(whole_patches) && to[i].inside(whole_patches);
        flow.is_reliable.push_back(found[i] != 0 && is_seen &&
                                   static_cast<double>(error[i]) < reliable_error);
    }
    return flow;
}

/// Motion of the background at a place: pan + turn * (place - centre), the product of complex numbers.
struct BackgroundMotion {
    Vec2 pan;
    Vec2 turn;
    Vec2 centre;

    Vec2 at(Vec2 place) const {
        const Vec2 p = place - centre;
        return pan + Vec2{turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x};
    }
};

Vec2 place_on_grid(const Flow& flow, std::size_t i) {
    const auto index = static_cast<int>(i);
    const int row = index / flow.grid.width;
    const Vec2 cell{index % flow.grid.width + 0.5, row + 0.5};
    return cell * grid_step;
}

/// One step of iterated least squares, each vector weighted by how well the motion so far explains it.
BackgroundMotion refitted(const Flow& flow, const BackgroundMotion& now) {
    Vec2 sum_p;
    Vec2 sum_v;
    double sum = 0;
    std::vector<double> weights(flow.vectors.size());
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        if (!flow.is_reliable[i]) continue;
        const double residual = length(flow.vectors[i] - now.at(place_on_grid(flow, i))) / explained;
        weights[i] = 1 / ((1 + residual * residual) * (1 + residual * residual));
        sum += weights[i];
        sum_p = sum_p + place_on_grid(flow, i) * weights[i];
        sum_v = sum_v + flow.vectors[i] * weights[i];
    }
    if (sum <= 0) return now;
    BackgroundMotion next{.pan = sum_v * (1 / sum), .turn = {}, .centre = sum_p * (1 / sum)};
    double spread = 0;
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        const Vec2 p = place_on_grid(flow, i) - next.centre;
        const Vec2 v = flow.vectors[i] - next.pan;
        spread += weights[i] * dot(p, p);
        next.turn = next.turn + Vec2{dot(p, v), cross(p, v)} * weights[i];
    }
    next.turn = spread > 0 ? next.turn * (1 / spread) : Vec2{};
    return next;
}

/// |v - background| on the grid, 0 where the flow has no answer.
cv::Mat contrast_on_grid(const Flow& flow, const BackgroundMotion& background) {
    cv::Mat contrast = cv::Mat::zeros(flow.grid, CV_32FC1);
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        if (!flow.is_reliable[i]) continue;
        const auto index = static_cast<int>(i);
        contrast.at<float>(index / flow.grid.width, index % flow.grid.width) =
            static_cast<float>(length(flow.vectors[i] - background.at(place_on_grid(flow, i))));
    }
    return contrast;
}

/// The contrast without outliers, less its median, which is the flow's noise.
cv::Mat denoised(const cv::Mat& contrast) {
    cv::Mat result;
    cv::medianBlur(contrast, result, 3);
    const std::vector<double> all(result.begin<float>(), result.end<float>());
    return cv::max(result - median(all), 0);
}

}  // namespace

Vec2 voted_motion(std::span<const Vec2> vectors) {
    if (vectors.empty()) return {};
    double fastest = 0;
    for (const Vec2 v : vectors)
        fastest = std::max(fastest, length(v));
    const double step = std::max(still, fastest / magnitude_bins);
    std::vector<Bin> bins;
    for (const Vec2 v : vectors)
        bins.push_back(bin_of(v, step));
    const Bin best = winning_bin(bins);
    std::vector<double> xs;
    std::vector<double> ys;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        if (!are_neighbours(best, bins[i])) continue;
        xs.push_back(vectors[i].x);
        ys.push_back(vectors[i].y);
    }
    return {median(std::move(xs)), median(std::move(ys))};
}

MotionContrast motion_contrast(const cv::Mat& before, const cv::Mat& after, MotionMethod method) {
    if (std::min(before.cols, before.rows) < least_side)
        return {SaliencyMap::zeros(before.size(), CV_32FC1), {}};
    const Flow flow = tracked_grid(before, after, method);
    std::vector<Vec2> reliable;
    for (std::size_t i = 0; i < flow.vectors.size(); ++i) {
        if (flow.is_reliable[i]) reliable.push_back(flow.vectors[i]);
    }
    const Vec2 global = voted_motion(reliable);
    BackgroundMotion background{.pan = global, .turn = {}, .centre = {}};
    cv::Mat contrast;
    double floor = std::numeric_limits<double>::min();
    if (method == MotionMethod::voted_pan) {
        contrast = contrast_on_grid(flow, background);
    } else {
        for (int i = 0; i < refits; ++i)
            background = refitted(flow, background);
        contrast = denoised(contrast_on_grid(flow, background));
        floor = noise_floor * std::hypot(before.cols, before.rows) + camera_floor * length(global);
    }
    double fastest = 0;
    cv::minMaxLoc(contrast, nullptr, &fastest);
    SaliencyMap map;
    cv::resize(contrast / std::max(fastest, floor), map, before.size(), 0, 0, cv::INTER_LINEAR);
    return {map, global};
}

}  // namespace vitrine
