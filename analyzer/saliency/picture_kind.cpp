#include "analyzer/saliency/picture_kind.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace vitrine::analyzer {

namespace {

constexpr int near_ground = 10;         // levels of a channel: noise of the coding
constexpr int colourless = 16;          // levels between two channels of a grey
constexpr double min_ground = .75;      // share of a title's picture
constexpr double max_spread = 2.5;      // standard deviation of a title's ground: drawn, not filmed
constexpr int min_changes = 8;          // from ground to ink and back, in one row of words
constexpr double max_left_over = .002;  // share of a plain picture that may be something else

/// The grey that most of the picture is near to, in [0, 255].
int ground_level(const cv::Mat& grey) {
    std::array<int, 256> counts{};
    for (int y = 0; y < grey.rows; ++y)
        for (int x = 0; x < grey.cols; ++x)
            ++counts[grey.at<std::uint8_t>(y, x)];
    return static_cast<int>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

bool is_colourless(const cv::Scalar& bgr) {
    return std::max({bgr[0], bgr[1], bgr[2]}) - std::min({bgr[0], bgr[1], bgr[2]}) <= colourless;
}

/// 255 where a pixel is not of the ground.
cv::Mat outside_of(const cv::Mat& bgr, const cv::Scalar& ground) {
    const cv::Scalar margin = cv::Scalar::all(near_ground);
    cv::Mat inside;
    cv::inRange(bgr, ground - margin, ground + margin, inside);
    return ~inside;
}

/// The most changes from ground to ink or back in one row.
int max_changes(const cv::Mat& ink) {
    int most = 0;
    for (int y = 0; y < ink.rows; ++y) {
        int changes = 0;
        for (int x = 1; x < ink.cols; ++x)
            changes += ink.at<std::uint8_t>(y, x) != ink.at<std::uint8_t>(y, x - 1) ? 1 : 0;
        most = std::max(most, changes);
    }
    return most;
}

}  // namespace

PictureLook look_at(const cv::Mat& bgr, cv::Size size) {
    cv::Mat small;
    cv::resize(bgr, small, size, 0, 0, cv::INTER_AREA);
    cv::Mat grey;
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    const int level = ground_level(grey);
    cv::Mat is_near;
    cv::inRange(grey, level - near_ground, level + near_ground, is_near);
    cv::Scalar ground;
    cv::Scalar spread;
    cv::meanStdDev(small, ground, spread, is_near);
    if (!is_colourless(ground)) return {};
    const cv::Mat outside = outside_of(small, ground);
    const double share =
        static_cast<double>(cv::countNonZero(outside)) / static_cast<double>(outside.total());
    if (share <= max_left_over) return {PictureKind::plain, {}};
    if (1 - share < min_ground || std::max({spread[0], spread[1], spread[2]}) > max_spread) return {};
    if (max_changes(outside) < min_changes) return {};
    return {PictureKind::title, cv::boundingRect(outside)};
}

}  // namespace vitrine::analyzer
