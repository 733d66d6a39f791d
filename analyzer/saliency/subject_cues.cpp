#include "analyzer/saliency/subject_cues.hpp"

#include "analyzer/saliency/barrier_distance.hpp"
#include "analyzer/saliency/frequency_tuned.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr double working_side = 160;  // px, longest side
constexpr double smoothing = 0.012;   // share of the diagonal
// Share of the longest side by which colours are smoothed before barriers are measured.
constexpr double paint = 0.0067;
constexpr float min_cue = 0.01F;  // so that a cue that is nowhere is the same everywhere
constexpr float max_cue = 1.2F;
// Differences from which on a cue has its full strength, so that noise has none.
constexpr float min_barrier = 15;     // Lab units, summed over channels
constexpr float min_detail = 1;       // grey levels
constexpr float min_distance = 0.1F;  // share of the sides
constexpr double max_detail = 25;     // grey levels: more contrast does not make an edge sharper

void smooth(cv::Mat& map) {
    const double sigma = smoothing * std::hypot(map.cols, map.rows);
    cv::GaussianBlur(map, map, {0, 0}, std::max(0.5, sigma), 0, cv::BORDER_REPLICATE);
}

/// Maps the 5th to the 99.5th percentile, or `range` if that is more, to [0, 1].
void stretch(cv::Mat& map, float range) {
    std::vector<float> values;
    for (std::size_t i = 0; i < map.total(); i += 4)
        values.push_back(map.ptr<float>()[i]);
    const auto at = [&values](double share) {
        const auto place =
            values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), place, values.end());
        return *place;
    };
    const float low = at(0.05);
    const float scale = 1 / std::max(range, at(0.995) - low);
    map.forEach<float>(
        [=](float& value, const int*) { value = std::clamp((value - low) * scale, 0.F, max_cue) + min_cue; });
}

cv::Mat detail(const cv::Mat& bgr, cv::Size size) {
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::Mat blurred;
    cv::GaussianBlur(grey, blurred, {5, 5}, 1, 0, cv::BORDER_REPLICATE);
    cv::absdiff(grey, blurred, grey);
    cv::Mat fine;
    cv::min(grey, max_detail, fine);
    fine.convertTo(fine, CV_32F);
    cv::resize(fine, fine, size, 0, 0, cv::INTER_AREA);
    return fine;
}

// Colours are counted in cells of Lab; neighbouring cells share their counts.
constexpr std::array<int, 3> cells{8, 12, 12};
constexpr std::array<float, 3> cell_origin{0, -64, -64};
constexpr std::array<float, 3> cell_size{100.F / 8, 128.F / 12, 128.F / 12};

int cell_of(const cv::Vec3f& colour) {
    int cell = 0;
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const int place = static_cast<int>((colour[k] - cell_origin[i]) / cell_size[i]);
        cell = cell * cells[i] + std::clamp(place, 0, cells[i] - 1);
    }
    return cell;
}

/// Blurs counts by 1 2 1 along each of the three axes of cells.
void share_with_neighbours(std::vector<float>& counts) {
    int step = cells[1] * cells[2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<float> from = counts;
        for (int i = 0; i < static_cast<int>(from.size()); ++i) {
            const int place = i / step % cells[axis];
            const auto at = [&](int k) { return from[static_cast<std::size_t>(k)]; };
            const float before = at(place > 0 ? i - step : i);
            const float after = at(place + 1 < cells[axis] ? i + step : i);
            counts[static_cast<std::size_t>(i)] = (before + 2 * at(i) + after) / 4;
        }
        if (axis < 2) step /= cells[axis + 1];
    }
}

/// Minus the mean distance from the picture's middle, in sides, of the places that have a pixel's colour.
cv::Mat nearness_of_colours(const cv::Mat& lab) {
    constexpr auto count = std::size_t{cells[0]} * std::size_t{cells[1]} * std::size_t{cells[2]};
    std::vector<float> pixels(count, 1e-9F);
    std::vector<float> distances(count, 0);
    cv::Mat cell(lab.size(), CV_32SC1);
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const int c = cell_of(lab.at<cv::Vec3f>(y, x));
            cell.at<int>(y, x) = c;
            const double dx = (x + 0.5) / lab.cols - 0.5;
            const double dy = (y + 0.5) / lab.rows - 0.5;
            pixels[static_cast<std::size_t>(c)] += 1;
            distances[static_cast<std::size_t>(c)] += static_cast<float>(std::sqrt(dx * dx + dy * dy));
        }
    }
    share_with_neighbours(pixels);
    share_with_neighbours(distances);
    cv::Mat result(lab.size(), CV_32FC1);
    for (std::size_t i = 0; i < result.total(); ++i) {
        const auto c = static_cast<std::size_t>(cell.ptr<int>()[i]);
        result.ptr<float>()[i] = -distances[c] / pixels[c];
    }
    return result;
}

}  // namespace

SubjectCues subject_cues(const cv::Mat& bgr) {
    const double longest = std::max(bgr.cols, bgr.rows);
    const double scale = std::min(1.0, working_side / longest);
    const cv::Size size = scaled_size(bgr.size(), scale);
    cv::Mat small;
    cv::resize(bgr, small, size, 0, 0, cv::INTER_AREA);
    const cv::Mat colours = lab(small);
    cv::Mat painted;
    cv::GaussianBlur(colours, painted, {0, 0}, std::max(0.5, paint * std::max(size.width, size.height)));
    SubjectCues cues{.enclosed = barrier_distance(painted),
                     .sharp = detail(bgr, size),
                     .central = nearness_of_colours(colours)};
    for (cv::Mat* map : {&cues.enclosed, &cues.sharp, &cues.central})
        smooth(*map);
    stretch(cues.enclosed, min_barrier);
    stretch(cues.sharp, min_detail);
    stretch(cues.central, min_distance);
    return cues;
}

}  // namespace vitrine::analyzer
