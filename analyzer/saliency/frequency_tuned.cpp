#include "analyzer/saliency/frequency_tuned.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace vitrine::analyzer {
namespace {

// A maximum below so many Lab units is not fully salient: about four just-noticeable steps.
constexpr double min_contrast = 10;

/// sRGB to CIE Lab by tables of our own: OpenCV's take 120 ms of software floating point to set up, more than
/// all else a photo needs.
class LabTables {
  public:
    LabTables() {
        for (std::size_t i = 0; i < light_.size(); ++i) {
            const double code = static_cast<double>(i) / 255;
            light_[i] =
                static_cast<float>(code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4));
        }
        for (std::size_t i = 0; i < root_.size(); ++i) {
            const double t = static_cast<double>(i) / steps;
            root_[i] = static_cast<float>(t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116);
        }
    }

    cv::Vec3f lab(const cv::Vec3b& bgr) const {
        const float red = light_[bgr[2]];
        const float green = light_[bgr[1]];
        const float blue = light_[bgr[0]];
        const float x = root((0.412453F * red + 0.357580F * green + 0.180423F * blue) / 0.950456F);
        const float y = root(0.212671F * red + 0.715160F * green + 0.072169F * blue);
        const float z = root((0.019334F * red + 0.119193F * green + 0.950227F * blue) / 1.088754F);
        return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
    }

  private:
    static constexpr int steps = 4096;  // the line between two is off by less than 6e-6

    /// The cube root of Lab, t in [0, 1] and a little beyond.
    float root(float t) const {
        const float at = t * steps;
        const auto step = static_cast<std::size_t>(at);
        return root_[step] + (at - static_cast<float>(step)) * (root_[step + 1] - root_[step]);
    }

    std::array<float, 256> light_{};
    std::array<float, steps + 3> root_{};  // white may come to a little more than 1
};

}  // namespace

cv::Mat lab(const cv::Mat& bgr) {
    static const LabTables tables;
    cv::Mat result(bgr.size(), CV_32FC3);
    for (int y = 0; y < bgr.rows; ++y) {
        const auto* from = bgr.ptr<cv::Vec3b>(y);
        auto* to = result.ptr<cv::Vec3f>(y);
        for (int x = 0; x < bgr.cols; ++x)
            to[x] = tables.lab(from[x]);
    }
    return result;
}

SaliencyMap frequency_tuned(const cv::Mat& lab) {
    const cv::Scalar mean = cv::mean(lab);
    const cv::Vec3f mu(static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2]));
    const cv::Matx<float, 1, 5> binomial(1.F / 16, 4.F / 16, 6.F / 16, 4.F / 16, 1.F / 16);
    cv::Mat blurred;
    cv::sepFilter2D(lab, blurred, CV_32F, binomial, binomial, {-1, -1}, 0, cv::BORDER_REPLICATE);
    SaliencyMap result(lab.size(), CV_32FC1);
    float highest = static_cast<float>(min_contrast);
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

}  // namespace vitrine::analyzer
