#include "analyzer/one_file/subject_network.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

namespace vitrine::analyzer {
namespace {

constexpr const char* student = VITRINE_MODELS "/student.onnx";

cv::Mat ball_on_floor() {
    cv::Mat picture(360, 640, CV_8UC3, cv::Scalar(90, 90, 90));
    cv::circle(picture, {420, 180}, 90, cv::Scalar(30, 40, 200), cv::FILLED, cv::LINE_AA);
    return picture;
}

}  // namespace

TEST_CASE("the subject of a photo is the mean of a large and a small look") {
    const FramePair pair{ball_on_floor(), {}, 1};
    const auto network = photo_network({.saliency_model = student, .is_student = true});
    REQUIRE(network);
    const SaliencyMap subject = network->find(pair);
    const SaliencyMap small = find_subject(*open_network(student, 160), pair);
    const SaliencyMap large = find_subject(*open_network(student, 224), pair);
    CHECK(cv::norm(small, large, cv::NORM_INF) > 0.01);
    CHECK(cv::norm(subject, (small + large) / 2, cv::NORM_INF) < 1e-4);
}

TEST_CASE("a large network does not look at photos where it is not to") {
    CHECK_FALSE(photo_network({.saliency_model = VITRINE_MODELS "/u2netp.onnx", .looks_at_photos = false}));
    CHECK_FALSE(photo_network({.saliency_model = ""}));
}

}  // namespace vitrine::analyzer
