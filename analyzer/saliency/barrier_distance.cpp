#include "analyzer/saliency/barrier_distance.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vitrine {
namespace {

constexpr int passes = 3;
constexpr double strip = 0.1;  // of the side, as wide as a border strip is
constexpr double regularity =
    10;  // Lab units^2 added to the border's variance, so that a flat sky is no needle

/// One channel's distance with, for each pixel, the highest and lowest value on its best path.
struct Barrier {
    cv::Mat values;
    cv::Mat distance;
    cv::Mat highest;
    cv::Mat lowest;
};

/// Lets the best path of a neighbour go on to (x, y) where that is cheaper.
void relax(Barrier& b, int x, int y, int from_x, int from_y) {
    const float value = b.values.at<float>(y, x);
    const float high = std::max(b.highest.at<float>(from_y, from_x), value);
    const float low = std::min(b.lowest.at<float>(from_y, from_x), value);
    if (high - low >= b.distance.at<float>(y, x)) return;
    b.distance.at<float>(y, x) = high - low;
    b.highest.at<float>(y, x) = high;
    b.lowest.at<float>(y, x) = low;
}

void scan(Barrier& b, bool is_forward) {
    const int w = b.values.cols;
    const int h = b.values.rows;
    const int step = is_forward ? 1 : -1;
    for (int k = 1; k + 1 < h; ++k) {
        const int y = is_forward ? k : h - 1 - k;
        for (int i = 1; i + 1 < w; ++i) {
            const int x = is_forward ? i : w - 1 - i;
            relax(b, x, y, x, y - step);
            relax(b, x, y, x - step, y);
        }
    }
}

cv::Mat barrier_distance_of(const cv::Mat& values) {
    Barrier b{.values = values,
              .distance = cv::Mat(values.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::max())),
              .highest = values.clone(),
              .lowest = values.clone()};
    for (const cv::Rect edge :
         {cv::Rect(0, 0, values.cols, 1), cv::Rect(0, values.rows - 1, values.cols, 1),
          cv::Rect(0, 0, 1, values.rows), cv::Rect(values.cols - 1, 0, 1, values.rows)}) {
        b.distance(edge).setTo(0);
    }
    for (int pass = 0; pass < passes; ++pass)
        scan(b, pass % 2 == 0);
    return b.distance;
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
    std::array<cv::Mat, 3> channels;
    cv::split(lab, channels.data());
    cv::Mat sum = cv::Mat::zeros(lab.size(), CV_32FC1);
    for (const cv::Mat& channel : channels)
        sum += barrier_distance_of(channel);
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

}  // namespace vitrine
