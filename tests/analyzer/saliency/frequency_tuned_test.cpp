#include "analyzer/saliency/frequency_tuned.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

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
