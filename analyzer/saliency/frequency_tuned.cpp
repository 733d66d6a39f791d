#include "analyzer/saliency/frequency_tuned.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

constexpr double least_contrast =
    10;  // Lab units that count as fully salient at least: about four just-noticeable steps

}  // namespace

cv::Mat lab(const cv::Mat& bgr) {
    cv::Mat unit;
    bgr.convertTo(unit, CV_32FC3, 1.0 / 255);
    cv::Mat result;
    cv::cvtColor(unit, result, cv::COLOR_BGR2Lab);
    return result;
}

SaliencyMap frequency_tuned(const cv::Mat& lab) {
    const cv::Scalar mean = cv::mean(lab);
    const cv::Vec3f mu(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
    const cv::Matx<float, 1, 5> binomial(1.F / 16, 4.F / 16, 6.F / 16, 4.F / 16, 1.F / 16);
    cv::Mat blurred;
    cv::sepFilter2D(lab, blurred, CV_32F, binomial, binomial, {-1, -1}, 0, cv::BORDER_REPLICATE);
    SaliencyMap result(lab.size(), CV_32FC1);
    float highest = static_cast<float>(least_contrast);
    for (int y = 0; y < lab.rows; ++y) {
        const auto* from = blurred.ptr<cv::Vec3f>(y);
        auto* to = result.ptr<float>(y);
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f d = from[x] - mu;
            to[x] = std::sqrt(d.dot(d));
            highest = std::max(highest, to[x]);
        }
    }
    result *= 1.0 / static_cast<double>(highest);
    return result;
}

}  // namespace vitrine
