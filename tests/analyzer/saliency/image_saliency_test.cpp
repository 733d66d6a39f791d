#include "analyzer/saliency/image_saliency.hpp"
#include "analyzer/saliency/saliency_network.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <array>
#include <cstring>
#include <string>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

const cv::Size photo{640, 360};
const cv::Scalar white(255, 255, 255);
const cv::Scalar black(0, 0, 0);

cv::Mat plain(const cv::Scalar& colour) {
    return {photo, CV_8UC3, colour};
}

/// The region of a photograph without faces, px of it.
Polygon region_of(const cv::Mat& picture) {
    const Sample sample = sample_of({picture, {}, 1}, {});
    return shot_region({sample}, {}, map_size(picture.size()), picture.size(), {}).shot.region.polygon;
}

void check_holds(const Polygon& region, const cv::Rect& box) {
    for (const cv::Point p :
         {box.tl(), cv::Point(box.x + box.width, box.y), box.br(), cv::Point(box.x, box.y + box.height)}) {
        CHECK(is_inside_convex(region, {static_cast<double>(p.x), static_cast<double>(p.y)}, 2));
    }
}

double share(const Polygon& region) {
    return area(region) / photo.area();
}

/// Writes a line of text and says where it stands.
cv::Rect written(cv::Mat& on, const std::string& text, cv::Point at, double size, const cv::Scalar& colour) {
    const int thickness = std::max(1, static_cast<int>(size * 1.5));
    int below = 0;
    const cv::Size extent = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, thickness, &below);
    cv::putText(on, text, at, cv::FONT_HERSHEY_SIMPLEX, size, colour, thickness, cv::LINE_AA);
    return {at.x, at.y - extent.height, extent.width, extent.height + below};
}

// ONNX is protocol buffers; these few lines write the messages that one convolution takes.
std::string varint(std::uint64_t value) {
    std::string bytes;
    for (; value >= 0x80; value >>= 7)
        bytes += static_cast<char>((value & 0x7F) | 0x80);
    return bytes + static_cast<char>(value);
}

std::string number(std::uint64_t field, std::uint64_t value) {
    return varint(field << 3) + varint(value);
}

std::string bytes(std::uint64_t field, const std::string& value) {
    return varint(field << 3 | 2) + varint(value.size()) + value;
}

std::string value_info(const std::string& name, std::initializer_list<std::uint64_t> sizes) {
    std::string shape;
    for (const std::uint64_t size : sizes)
        shape += bytes(1, number(1, size));
    return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

/// A weighted sum of the picture's channels, R, G and B.
std::string sum_node(const std::string& weights, const std::string& output) {
    const std::string kernel = bytes(1, "kernel_shape") + number(8, 1) + number(8, 1) + number(20, 7);
    return bytes(1, "x") + bytes(1, weights) + bytes(2, output) + bytes(4, "Conv") + bytes(5, kernel);
}

std::string weights(const std::string& name, const std::array<float, 3>& values) {
    std::string raw(sizeof values, '\0');
    std::memcpy(raw.data(), values.data(), sizeof values);
    return number(1, 1) + number(1, 3) + number(1, 1) + number(1, 1) + number(2, 1) + bytes(8, name) +
           bytes(9, raw);
}

/// A network whose first map is the picture's blue less its red. A second one is red less blue: like U2-Net,
/// it gives several, of which the first counts.
std::string blue_network() {
    const std::string graph = bytes(1, sum_node("w", "y")) + bytes(1, sum_node("v", "z")) + bytes(2, "g") +
                              bytes(5, weights("w", {-1, 0, 1})) + bytes(5, weights("v", {1, 0, -1})) +
                              bytes(11, value_info("x", {1, 3, 320, 320})) +
                              bytes(12, value_info("y", {1, 1, 320, 320})) +
                              bytes(12, value_info("z", {1, 1, 320, 320}));
    return number(1, 7) + bytes(7, graph) + bytes(8, number(2, 11));
}

}  // namespace

TEST_CASE("black and flat pictures keep a large middle, in the range of a map") {
    for (const cv::Scalar& colour : {black, white, cv::Scalar(40, 90, 200)}) {
        const cv::Mat picture = plain(colour);
        const SaliencyMap map = image_saliency_stage(ImageSaliency::subject)->map(picture, {});
        CHECK(map.size() == picture.size());
        CHECK(cv::checkRange(map, true, nullptr, 0, 1.0001));
        const Polygon region = region_of(picture);
        CHECK(share(region) > 0.3);
        CHECK(std::abs(centroid(region).x - photo.width / 2.0) < 0.05 * photo.width);
    }
}

TEST_CASE("an all-over texture keeps most of the picture") {
    cv::Mat picture(photo, CV_8UC3);
    cv::RNG random(7);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    CHECK(share(region_of(picture)) > 0.3);
}

TEST_CASE("a small thing on a plain ground is whole and tightly enclosed, wherever it is") {
    for (const cv::Point at : {cv::Point(180, 120), cv::Point(320, 180), cv::Point(450, 230)}) {
        cv::Mat picture = plain({120, 160, 120});
        cv::circle(picture, at, 40, {20, 30, 220}, cv::FILLED, cv::LINE_AA);
        cv::circle(picture, at, 12, {230, 230, 230}, cv::FILLED, cv::LINE_AA);
        const Polygon region = region_of(picture);
        check_holds(region, {at.x - 40, at.y - 40, 80, 80});
        CHECK(share(region) < 0.5);
    }
}

TEST_CASE("a poster's lines are not cut") {
    cv::Mat picture = plain({235, 240, 240});
    const cv::Rect title = written(picture, "SUMMER NIGHTS", {90, 90}, 1.9, {30, 30, 160});
    const cv::Rect when = written(picture, "Friday 8 pm, old harbour", {130, 200}, 1.1, {40, 40, 40});
    const cv::Rect foot = written(picture, "tickets at the door", {190, 310}, 0.9, {40, 40, 40});
    const Polygon region = region_of(picture);
    for (const cv::Rect& line : {title, when, foot})
        check_holds(region, line);
}

TEST_CASE("a title on black is whole") {
    cv::Mat picture = plain(black);
    const cv::Rect title = written(picture, "THE OLD MILL", {110, 190}, 1.9, white);
    check_holds(region_of(picture), title);
}

TEST_CASE("a logo on white is whole") {
    cv::Mat picture = plain(white);
    cv::ellipse(picture, {320, 150}, {80, 80}, 0, 30, 330, {160, 60, 20}, 30, cv::LINE_AA);
    const cv::Rect name = written(picture, "circle", {240, 320}, 1.6, {40, 40, 40});
    const Polygon region = region_of(picture);
    check_holds(region, {225, 55, 190, 190});
    check_holds(region, name);
}

TEST_CASE("a face tells where the subject is") {
    // Given the same broad noise with a face at the left or at the right.
    cv::Mat picture(photo, CV_8UC3);
    cv::RNG random(9);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    const auto stage = image_saliency_stage(ImageSaliency::subject);
    const std::vector<Face> left{{.box = {{110, 90}, {170, 160}}, .score = 1}};
    const std::vector<Face> right{{.box = {{470, 90}, {530, 160}}, .score = 1}};
    const auto off_middle = [&](const std::vector<Face>& faces) {
        const cv::Moments m = cv::moments(stage->map(picture, faces));
        return m.m10 / m.m00 - photo.width / 2.0;
    };
    CHECK(off_middle(left) < -10);
    CHECK(off_middle(right) > 10);
}

TEST_CASE("a network finds the subject of a picture, whose shape its input has") {
    const auto size_and_check = [](cv::Size size, int side) {
        cv::Mat picture(size, CV_8UC3, cv::Scalar(60, 60, 60));
        picture(cv::Rect(size.width * 5 / 8, size.height / 4, size.width / 5, size.height / 4))
            .setTo(cv::Scalar(255, 60, 60));
        SaliencyNetwork network(std::make_shared<Network>("blue", blue_network()), side);
        SaliencyMap map = network.map(picture);
        const cv::Size input = map.size();
        cv::resize(map, map, picture.size());
        CHECK(map.at<float>(size.height * 3 / 8, size.width * 23 / 32) > 0.95F);
        CHECK(map.at<float>(size.height * 3 / 8, size.width / 6) < 0.05F);
        return input;
    };
    CHECK(size_and_check({640, 640}, 320) == cv::Size(320, 320));
    CHECK(size_and_check({640, 480}, 320) == cv::Size(384, 288));
    CHECK(size_and_check({480, 640}, 320) == cv::Size(288, 384));
    CHECK(size_and_check({640, 360}, 160) == cv::Size(224, 128));
    CHECK(size_and_check({1600, 100}, 320) == cv::Size(640, 96));
}

TEST_CASE("one network looks at pictures of several shapes") {
    SaliencyNetwork network(std::make_shared<Network>("blue", blue_network()), 160);
    CHECK(network.map(cv::Mat(360, 640, CV_8UC3)).size() == cv::Size(224, 128));
    CHECK(network.map(cv::Mat(640, 360, CV_8UC3)).size() == cv::Size(128, 224));
    CHECK(network.map(cv::Mat(360, 640, CV_8UC3)).size() == cv::Size(224, 128));
}

TEST_CASE("a saliency model that cannot be read is named") {
    CHECK_THROWS_WITH_AS(Network("blue.onnx", "no model"), doctest::Contains("blue.onnx"),
                         std::runtime_error);
}
