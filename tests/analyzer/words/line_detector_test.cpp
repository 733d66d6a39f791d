#include "analyzer/words/line_detector.hpp"

#include "analyzer/explain/canvas.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <string_view>

namespace vitrine::analyzer {
namespace {

/// Draws a line and returns the box of its ink.
Box drawn_line(Canvas& canvas, std::string_view words, Vec2 at, const TextStyle& style) {
    const cv::Mat before = canvas.picture().clone();
    canvas.text(words, at, style);
    cv::Mat changed;
    cv::absdiff(before, canvas.picture(), changed);
    cv::cvtColor(changed, changed, cv::COLOR_BGR2GRAY);
    const cv::Rect ink = cv::boundingRect(changed > 24);
    return {{static_cast<double>(ink.x), static_cast<double>(ink.y)},
            {static_cast<double>(ink.br().x), static_cast<double>(ink.br().y)}};
}

/// Says if boxes together hold a line, but for 2 px that are soft edges.
bool is_held(const std::vector<Box>& found, const Box& line) {
    Box held{{1e9, 1e9}, {-1e9, -1e9}};
    for (const Box& box : found)
        if (!intersection(box, line).is_empty()) held = united(held, box);
    return held.min.x <= line.min.x + 2 && held.min.y <= line.min.y + 2 && held.max.x >= line.max.x - 2 &&
           held.max.y >= line.max.y - 2;
}

}  // namespace

TEST_CASE("lines of several sizes, scripts and grounds are found whole") {
    LineDetector detector(VITRINE_MODELS "/text_detection.onnx");
    Canvas canvas(640, 400, 0x284060);
    canvas.fill({{0, 200}, {640, 400}}, 0xF0E8D0);
    const std::vector<Box> lines{drawn_line(canvas, "Tagesgericht 7,80 EUR", {30, 60}, {40, 0xFFFFFF}),
                                 drawn_line(canvas, "and a glass of water", {40, 130}, {22, 0xFFE080}),
                                 drawn_line(canvas, "Сегодня суп и рыба", {30, 250}, {28, 0x401010}),
                                 drawn_line(canvas, "ΑΝΟΙΧΤΑ ΚΑΘΕ ΜΕΡΑ", {200, 330}, {36, 0x0030A0})};
    (void)detector.find(cv::Mat(300, 200, CV_8UC3, cv::Scalar::all(0)), 320);  // another size before
    const std::vector<Box> found = detector.find(canvas.picture(), 640);
    for (const Box& line : lines) {
        CAPTURE(line.min.y);
        CHECK(is_held(found, line));
    }
    CHECK(found.size() <= 8);
}

TEST_CASE("a picture without words has no lines") {
    LineDetector detector(VITRINE_MODELS "/text_detection.onnx");
    cv::Mat picture(360, 640, CV_8UC3);
    cv::RNG random(3);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(picture, picture, {0, 0}, 9);
    cv::normalize(picture, picture, 0, 255, cv::NORM_MINMAX);
    CHECK(detector.find(picture, 640).empty());
    CHECK(detector.find(cv::Mat(90, 160, CV_8UC3, cv::Scalar::all(0)), 640).empty());
}

TEST_CASE("a file that is no such network is told by its name") {
    CHECK_THROWS_WITH(LineDetector("/nowhere/text.onnx"), doctest::Contains("/nowhere/text.onnx"));
    LineDetector faces(VITRINE_MODELS "/face_detection_yunet.onnx");
    CHECK_THROWS_WITH(faces.find(cv::Mat(320, 320, CV_8UC3, cv::Scalar::all(9)), 320),
                      doctest::Contains("face_detection_yunet.onnx"));
}

}  // namespace vitrine::analyzer
