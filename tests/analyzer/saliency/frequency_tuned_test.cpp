#include "analyzer/saliency/frequency_tuned.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

/// CIE Lab of an sRGB colour under D65, from the definitions.
std::array<double, 3> lab_of(const cv::Vec3b& bgr) {
    const auto light = [](double code) {
        return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
    };
    const double r = light(bgr[2] / 255.0);
    const double g = light(bgr[1] / 255.0);
    const double b = light(bgr[0] / 255.0);
    const auto root = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const double x = root((0.412453 * r + 0.357580 * g + 0.180423 * b) / 0.950456);
    const double y = root(0.212671 * r + 0.715160 * g + 0.072169 * b);
    const double z = root((0.019334 * r + 0.119193 * g + 0.950227 * b) / 1.088754);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// Frequency-tuned saliency pixel by pixel, in double precision.
std::vector<double> reference(const cv::Mat& bgr) {
    const auto colour = [&bgr](int y, int x) {
        return lab_of(bgr.at<cv::Vec3b>(std::clamp(y, 0, bgr.rows - 1), std::clamp(x, 0, bgr.cols - 1)));
    };
    std::array<double, 3> mean{};
    for (int i = 0; i < bgr.rows * bgr.cols; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            mean[k] += colour(i / bgr.cols, i % bgr.cols)[k] / (bgr.rows * bgr.cols);
    }
    constexpr std::array<double, 5> binomial{1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
    std::vector<double> result;
    for (int i = 0; i < bgr.rows * bgr.cols; ++i) {
        std::array<double, 3> off{-mean[0], -mean[1], -mean[2]};
        for (int dy = -2; dy <= 2; ++dy) {
            for (int dx = -2; dx <= 2; ++dx) {
                const auto c = colour(i / bgr.cols + dy, i % bgr.cols + dx);
                const double weight =
                    binomial[static_cast<std::size_t>(dy + 2)] * binomial[static_cast<std::size_t>(dx + 2)];
                for (std::size_t k = 0; k < 3; ++k)
                    off[k] += weight * c[k];
            }
        }
        result.push_back(std::sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]));
    }
    const double highest = std::max(10.0, *std::max_element(result.begin(), result.end()));
    for (double& value : result)
        value /= highest;
    return result;
}

}  // namespace

TEST_CASE("the map differs from the definition in double precision by less than 1/255") {
    cv::Mat bgr(24, 36, CV_8UC3);
    cv::RNG random(11);
    random.fill(bgr, cv::RNG::UNIFORM, 0, 256);
    bgr(cv::Rect(8, 6, 14, 10)).setTo(cv::Scalar(20, 200, 240));
    const SaliencyMap map = frequency_tuned(lab(bgr));
    const std::vector<double> wanted = reference(bgr);
    double worst = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        worst = std::max(worst, std::abs(wanted[i] - static_cast<double>(map.ptr<float>()[i])));
    CHECK(worst < 1.0 / 255);
}

TEST_CASE("Lab has its true scale: white is (100, 0, 0) and black is (0, 0, 0)") {
    cv::Mat bgr(1, 2, CV_8UC3, cv::Scalar(0, 0, 0));
    bgr.at<cv::Vec3b>(0, 1) = {255, 255, 255};
    const cv::Mat result = lab(bgr);
    CHECK(result.at<cv::Vec3f>(0, 0)[0] == doctest::Approx(0).epsilon(1e-3));
    CHECK(result.at<cv::Vec3f>(0, 1)[0] == doctest::Approx(100).epsilon(1e-3));
    CHECK(std::abs(result.at<cv::Vec3f>(0, 1)[1]) < 0.01F);
}

TEST_CASE("of two colours the rarer is salient in the ratio of their shares") {
    // A quarter black, the rest white: the mean lies at L = 75, so black is 75 away and white 25.
    cv::Mat bgr(40, 40, CV_8UC3, cv::Scalar(255, 255, 255));
    bgr(cv::Rect(0, 0, 10, 40)).setTo(cv::Scalar(0, 0, 0));
    const SaliencyMap map = frequency_tuned(lab(bgr));
    CHECK(map.at<float>(20, 2) == doctest::Approx(1).epsilon(1e-3));
    CHECK(map.at<float>(20, 30) == doctest::Approx(25.0 / 75).epsilon(1e-3));
}

TEST_CASE("a flat picture with faint noise is not salient") {
    cv::Mat bgr(40, 40, CV_8UC3, cv::Scalar(120, 120, 120));
    bgr.at<cv::Vec3b>(20, 20) = {124, 124, 124};
    double highest = 0;
    cv::minMaxLoc(frequency_tuned(lab(bgr)), nullptr, &highest);
    CHECK(highest < 0.1);
}
