#include "analyzer/saliency/sample.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

namespace vitrine::analyzer {
namespace {

/// Enlarged, the detector takes it for a letter.
/// @param half_length  px; half of it is the car's half width
cv::Mat car_from_above(cv::Size size, int half_length) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar(90, 80, 80));
    const cv::Point centre(size.width * 5 / 16, size.height / 2);
    const int half_width = half_length / 2;
    cv::ellipse(picture, centre, {half_width, half_length}, 0, 0, 360, cv::Scalar(220, 210, 230), cv::FILLED,
                cv::LINE_AA);
    for (const int y : {-half_length / 2, half_length / 4})
        cv::rectangle(picture, centre + cv::Point(-half_width * 2 / 3, y),
                      centre + cv::Point(half_width * 2 / 3, y + half_length / 4), cv::Scalar(40, 30, 30),
                      cv::FILLED);
    return picture;
}

}  // namespace

TEST_CASE("frames of any shape have maps, however narrow they are") {
    for (const cv::Size size : {cv::Size(2, 2), cv::Size(16384, 2), cv::Size(2, 16384), cv::Size(3840, 64)}) {
        CAPTURE(size.width);
        CAPTURE(size.height);
        const cv::Mat grey(size, CV_8UC3, cv::Scalar::all(90));
        const Sample sample = sample_of({.frame = grey, .before = grey}, {});
        CHECK(sample.motion.size() == map_size(size));
        CHECK(sample.image.size() == map_size(size));
        CHECK(map_size(size).area() > 0);
    }
}

TEST_CASE("a thing that looks like one large letter is no line of words; words beside it are one") {
    LineDetector detector(VITRINE_MODELS "/text_detection.onnx");
    for (const int half_length : {36, 48, 52}) {
        CAPTURE(half_length);
        CHECK(find_lines(detector, {car_from_above({320, 180}, half_length), {}}).empty());
    }
    for (const int half_length : {32, 40}) {
        CAPTURE(half_length);
        cv::Mat picture = car_from_above({320, 180}, half_length);
        cv::putText(picture, "Parking", {200, 40}, cv::FONT_HERSHEY_SIMPLEX, 0.8, cv::Scalar::all(250), 2,
                    cv::LINE_AA);
        const std::vector<Box> lines = find_lines(detector, {picture, {}});
        REQUIRE(lines.size() == 1);
        CHECK(lines.front().min.x < 101);  // px of the map, which is half as large
        CHECK(lines.front().min.x > 90);
        CHECK(lines.front().max.x > 145);
    }
}

TEST_CASE("no line is searched where a small look sees no trace of one: enlarged, strokes look like words") {
    LineDetector detector(VITRINE_MODELS "/text_detection.onnx");
    cv::Mat arc(180, 320, CV_8UC3, cv::Scalar::all(173));
    cv::ellipse(arc, {88, 63}, {5, 5}, 104, 0, 129, cv::Scalar::all(130), 1);
    cv::Mat two_arcs(180, 320, CV_8UC3, cv::Scalar::all(146));
    cv::ellipse(two_arcs, {102, 55}, {8, 2}, 20, 0, 228, cv::Scalar::all(194), 2);
    cv::ellipse(two_arcs, {119, 55}, {5, 5}, 119, 0, 261, cv::Scalar::all(210), 1);
    for (const cv::Mat& strokes : {arc, two_arcs}) {
        CHECK_FALSE(LineDetector(VITRINE_MODELS "/text_detection.onnx").find(strokes, 640).empty());
        CHECK(find_lines(detector, {strokes, {}}).empty());
    }
}

}  // namespace vitrine::analyzer
