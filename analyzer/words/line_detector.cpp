#include "analyzer/words/line_detector.hpp"

#include "base/system/atomic_file.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::analyzer {
namespace {

constexpr int input_multiple = 32;
constexpr double min_score = 0.6;      // mean value of a core
constexpr double growth = 1.5;         // a line is its core grown by area / length of the outline, times this
constexpr double room = 0.1;           // around the line, share of its height: for accents and descenders
constexpr double min_core_height = 3;  // px of the map

int to_multiple(double value) {
    return std::max(1, static_cast<int>(std::lround(value / input_multiple))) * input_multiple;
}

cv::Size input_size(cv::Size picture, int side) {
    const double scale = static_cast<double>(side) / std::max(picture.width, picture.height);
    return {to_multiple(picture.width * scale), to_multiple(picture.height * scale)};
}

cv::Mat input_of(const cv::Mat& bgr, cv::Size size) {
    cv::Mat resized;
    cv::resize(bgr, resized, size, 0, 0, size.width < bgr.cols ? cv::INTER_AREA : cv::INTER_LINEAR);
    return network_input(resized);
}

/// The upright box around a core that is grown to a whole line.
Box grown_box(const cv::RotatedRect& core) {
    const double width = core.size.width;
    const double height = core.size.height;
    const double grown = width * height * growth / (2 * (width + height));
    const double by = grown + room * (std::min(width, height) + 2 * grown);
    const cv::Size2f size(static_cast<float>(width + 2 * by), static_cast<float>(height + 2 * by));
    const cv::RotatedRect line(core.center, size, core.angle);
    std::array<cv::Point2f, 4> corners;
    line.points(corners.data());
    Box box{{1e9, 1e9}, {-1e9, -1e9}};
    for (const cv::Point2f& corner : corners) {
        const Vec2 at{static_cast<double>(corner.x), static_cast<double>(corner.y)};
        box = {{std::min(box.min.x, at.x), std::min(box.min.y, at.y)},
               {std::max(box.max.x, at.x), std::max(box.max.y, at.y)}};
    }
    return box;
}

/// Mean value of the map within an outline.
double score_of(const cv::Mat& map, const std::vector<cv::Point>& outline) {
    const cv::Rect around = cv::boundingRect(outline);
    cv::Mat mask = cv::Mat::zeros(around.size(), CV_8UC1);
    cv::fillPoly(mask, std::vector{outline}, cv::Scalar(255), cv::LINE_8, 0, -around.tl());
    return cv::mean(map(around), mask)[0];
}

}  // namespace

LineDetector::LineDetector(const std::string& file)
    : network_("text model '" + file + "'", read_file(file)) {}

cv::Mat LineDetector::map(const cv::Mat& bgr, int side) {
    return network_.map(input_of(bgr, input_size(bgr.size(), side)));
}

std::vector<Box> LineDetector::find(const cv::Mat& bgr, int side) {
    const cv::Mat map = this->map(bgr, side);
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(map >= line_core, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
    const double scale_x = static_cast<double>(bgr.cols) / map.cols;
    const double scale_y = static_cast<double>(bgr.rows) / map.rows;
    const Box picture{{0, 0}, {static_cast<double>(bgr.cols), static_cast<double>(bgr.rows)}};
    std::vector<Box> lines;
    for (const std::vector<cv::Point>& outline : outlines) {
        const cv::RotatedRect core = cv::minAreaRect(outline);
        if (std::min(core.size.width, core.size.height) < min_core_height) continue;
        if (score_of(map, outline) < min_score) continue;
        const Box box = grown_box(core);
        const Box line = intersection(
            {{box.min.x * scale_x, box.min.y * scale_y}, {box.max.x * scale_x, box.max.y * scale_y}},
            picture);
        if (!line.is_empty()) lines.push_back(line);
    }
    return lines;
}

}  // namespace vitrine::analyzer
