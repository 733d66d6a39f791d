#include "analyzer/saliency/barrier_distance.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr int passes = 3;
constexpr double strip = 0.1;  // width of a border strip, share of the side
// Lab units^2 added to the border's variance: that of a flat sky is nearly 0.
constexpr double regularity = 10;

/// One pixel of one channel: its value, and the best path to it so far.
struct PathPixel {
    float value = 0;
    float distance = std::numeric_limits<float>::max();
    float highest = 0;
    float lowest = 0;

    /// Takes over the best path of a neighbour, continued to this pixel, where that is cheaper.
    void relax(const PathPixel& from) {
        const float high = std::max(from.highest, value);
        const float low = std::min(from.lowest, value);
        if (high - low >= distance) return;
        distance = high - low;
        highest = high;
        lowest = low;
    }
};

std::vector<PathPixel> first_paths(const cv::Mat& lab, int channel) {
    std::vector<PathPixel> places;
    places.reserve(lab.total());
    for (int y = 0; y < lab.rows; ++y) {
        const auto* row = lab.ptr<cv::Vec3f>(y);
        for (int x = 0; x < lab.cols; ++x) {
            const float value = row[x][channel];
            PathPixel place{.value = value, .highest = value, .lowest = value};
            if (x == 0 || y == 0 || x + 1 == lab.cols || y + 1 == lab.rows) place.distance = 0;
            places.push_back(place);
        }
    }
    return places;
}

void scan(std::vector<PathPixel>& places, int w, int h, bool is_forward) {
    const std::ptrdiff_t step = is_forward ? 1 : -1;
    for (int k = 1; k + 1 < h; ++k) {
        const int y = is_forward ? k : h - 1 - k;
        PathPixel* place = places.data() + static_cast<std::ptrdiff_t>(y) * w + (is_forward ? 1 : w - 2);
        for (int i = 1; i + 1 < w; ++i, place += step) {
            place->relax(place[-step * w]);
            place->relax(place[-step]);
        }
    }
}

/// The distance of every pixel to the colours of one strip.
cv::Mat contrast_to(const cv::Mat& lab, const cv::Rect& where) {
    cv::Mat samples = lab(where).clone().reshape(1, where.area());
    cv::Mat covariance;
    cv::Mat mean;
    cv::calcCovarMatrix(samples, covariance, mean, cv::COVAR_NORMAL | cv::COVAR_ROWS | cv::COVAR_SCALE,
                        CV_32F);
    covariance += cv::Mat::eye(3, 3, CV_32F) * regularity;
    const cv::Matx33f inverse(cv::Mat(covariance.inv()));
    const cv::Vec3f mu(mean.at<float>(0), mean.at<float>(1), mean.at<float>(2));
    cv::Mat result(lab.size(), CV_32FC1);
    for (int y = 0; y < lab.rows; ++y) {
        const auto* from = lab.ptr<cv::Vec3f>(y);
        auto* to = result.ptr<float>(y);
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f d = from[x] - mu;
            to[x] = std::sqrt(std::max(0.F, d.dot(inverse * d)));
        }
    }
    double highest = 0;
    cv::minMaxLoc(result, nullptr, &highest);
    if (highest > 0) result /= highest;
    return result;
}

}  // namespace

cv::Mat barrier_distance(const cv::Mat& lab) {
    cv::Mat sum = cv::Mat::zeros(lab.size(), CV_32FC1);
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<PathPixel> places = first_paths(lab, channel);
        for (int pass = 0; pass < passes; ++pass)
            scan(places, lab.cols, lab.rows, pass % 2 == 0);
        auto* to = sum.ptr<float>();
        for (const PathPixel& place : places)
            *to++ += place.distance;
    }
    return sum;
}

cv::Mat border_contrast(const cv::Mat& lab) {
    const int across = std::max(1, static_cast<int>(strip * lab.cols));
    const int down = std::max(1, static_cast<int>(strip * lab.rows));
    cv::Mat sum = cv::Mat::zeros(lab.size(), CV_32FC1);
    cv::Mat most = cv::Mat::zeros(lab.size(), CV_32FC1);
    for (const cv::Rect where :
         {cv::Rect(0, 0, lab.cols, down), cv::Rect(0, lab.rows - down, lab.cols, down),
          cv::Rect(0, 0, across, lab.rows), cv::Rect(lab.cols - across, 0, across, lab.rows)}) {
        const cv::Mat contrast = contrast_to(lab, where);
        sum += contrast;
        most = cv::max(most, contrast);
    }
    cv::Mat result = sum - most;
    double highest = 0;
    cv::minMaxLoc(result, nullptr, &highest);
    if (highest > 0) result /= highest;
    return result;
}

}  // namespace vitrine::analyzer
