#include "analyzer/network/network.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace vitrine::analyzer {
namespace {

std::string model(const std::string& name) {
    std::ifstream file(std::string(VITRINE_MODELS "/") + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

cv::Mat input_of(cv::Size size) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar(90, 110, 80));
    cv::circle(picture, {size.width / 2, size.height / 2}, size.height / 4, cv::Scalar(20, 40, 230), -1);
    return network_input(picture);
}

}  // namespace

TEST_CASE("a network gives the same for a size, whatever sizes came between") {
    for (const char* name : {"student.onnx", "text_detection.onnx"}) {
        CAPTURE(name);
        Network network(name, model(name));
        const cv::Mat first = network.map(input_of({160, 96}));
        CHECK(network.map(input_of({96, 160})).rows > first.rows);
        CHECK(network.map(input_of({128, 128})).rows > first.rows);
        CHECK(cv::norm(network.map(input_of({160, 96})), first, cv::NORM_INF) == 0);
    }
}

TEST_CASE("a map that was given stays as it is when the network looks again") {
    Network network("student", model("student.onnx"));
    const cv::Mat first = network.map(input_of({160, 160}));
    const cv::Mat kept = first.clone();
    (void)network.map(network_input(cv::Mat(160, 160, CV_8UC3, cv::Scalar(255, 255, 255))));
    CHECK(cv::norm(first, kept, cv::NORM_INF) == 0);
}

TEST_CASE("only models that declare a square are made for another size") {
    CHECK(Network("student", model("student.onnx")).declares_square());
    CHECK(Network("u2netp", model("u2netp.onnx")).declares_square());
    CHECK_FALSE(Network("lines", model("text_detection.onnx")).declares_square());
}

TEST_CASE("the input has the means and deviations of ImageNet") {
    const cv::Mat input = network_input(cv::Mat(2, 3, CV_8UC3, cv::Scalar(255, 0, 51)));
    REQUIRE(input.dims == 4);
    CHECK(input.size[1] == 3);
    CHECK(input.size[2] == 2);
    CHECK(input.size[3] == 3);
    const auto* values = input.ptr<float>();
    CHECK(values[0] == doctest::Approx((1 - 0.485) / 0.229));
    CHECK(values[6] == doctest::Approx(-0.456 / 0.224));
    CHECK(values[12] == doctest::Approx((0.2 - 0.406) / 0.225));
}

TEST_CASE("a model that cannot be used is named") {
    CHECK_THROWS_WITH_AS(Network("model 'broken.onnx'", "no model"), doctest::Contains("broken.onnx"),
                         std::runtime_error);
    Network faces("model 'faces.onnx'", model("face_detection_yunet.onnx"));
    CHECK_THROWS_WITH_AS(faces.map(input_of({160, 160})), doctest::Contains("faces.onnx"),
                         std::runtime_error);
}

}  // namespace vitrine::analyzer
