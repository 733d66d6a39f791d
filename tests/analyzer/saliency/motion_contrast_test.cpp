#include "analyzer/saliency/motion_contrast.hpp"

#include "analyzer/saliency/background_motion.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

/// A soft random texture, large enough to be panned over.
cv::Mat texture() {
    cv::Mat picture(260, 400, CV_8UC1);
    cv::RNG random(5);
    random.fill(picture, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(picture, picture, {0, 0}, 2.5);
    cv::normalize(picture, picture, 0, 255, cv::NORM_MINMAX);
    return picture;
}

/// The texture seen from an offset, with a textured disc of radius 24 at a place of its own.
cv::Mat scene(cv::Point offset, cv::Point disc) {
    const cv::Mat background = texture();
    cv::Mat frame = background(cv::Rect(offset, cv::Size(320, 180))).clone();
    cv::Mat mask = cv::Mat::zeros(frame.size(), CV_8UC1);
    cv::circle(mask, disc, 24, 255, cv::FILLED);
    cv::Mat subject;
    cv::flip(background, subject, -1);
    cv::Mat moved = cv::Mat::zeros(frame.size(), CV_8UC1);
    const cv::Point corner = disc - cv::Point(60, 60);
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 120; ++x)
            moved.at<unsigned char>(corner + cv::Point(x, y)) = subject.at<unsigned char>(y, x);
    }
    moved.copyTo(frame, mask);
    return frame;
}

}  // namespace

TEST_CASE("the vote finds the motion of most, whatever the others do") {
    std::vector<Vec2> vectors(60, Vec2{3, 1});
    vectors.insert(vectors.end(), 40, Vec2{-8, 5});
    CHECK(voted_motion(vectors) == Vec2{3, 1});
    CHECK(voted_motion({}) == Vec2{});
}

TEST_CASE("a disc that moves against a panning background is salient, and only it is") {
    const MotionContrast found = motion_contrast(scene({20, 30}, {150, 90}), scene({24, 30}, {155, 90}));
    CHECK(found.global_motion.x == doctest::Approx(-4).epsilon(0.05));
    CHECK(std::abs(found.global_motion.y) < 0.2);
    cv::Mat inner = cv::Mat::zeros(180, 320, CV_8UC1);
    cv::circle(inner, {152, 90}, 16, 255, cv::FILLED);
    cv::Mat outer(180, 320, CV_8UC1, cv::Scalar(255));
    cv::circle(outer, {152, 90}, 48, 0, cv::FILLED);
    CHECK(cv::mean(found.map, inner)[0] > 0.7);
    CHECK(cv::mean(found.map, outer)[0] < 0.05);
}

TEST_CASE("noise on a still picture is no motion") {
    cv::Mat noise(180, 320, CV_8SC1);
    cv::RNG random(7);
    random.fill(noise, cv::RNG::NORMAL, 0, 3);
    const cv::Mat before = scene({20, 30}, {150, 90});
    cv::Mat after;
    cv::add(before, noise, after, {}, CV_8U);
    CHECK(cv::mean(motion_contrast(before, after).map)[0] < 0.15);
}

TEST_CASE("ground that a moving camera sees deeper and nearer is no subject") {
    // Given a pan of 8 px, in which the rows move up to 1.6 px more or less than the mean.
    cv::Mat across(180, 320, CV_32FC1);
    cv::Mat down(180, 320, CV_32FC1);
    for (int y = 0; y < 180; ++y) {
        for (int x = 0; x < 320; ++x) {
            across.at<float>(y, x) =
                static_cast<float>(x) + 28 + 1.6F * std::sin(static_cast<float>(y) / 12.0F);
            down.at<float>(y, x) = static_cast<float>(y) + 30;
        }
    }
    cv::Mat after;
    cv::remap(texture(), after, across, down, cv::INTER_LINEAR);
    const cv::Mat before = texture()(cv::Rect(20, 30, 320, 180)).clone();
    const MotionContrast found = motion_contrast(before, after);
    CHECK(found.global_motion.x == doctest::Approx(-8).epsilon(0.2));
    double strongest = 0;
    cv::minMaxLoc(found.map, nullptr, &strongest);
    CHECK(strongest < 0.5);
}

TEST_CASE("what is at the edge of a panned picture counts as seen in one picture only") {
    const FlowField flow = dense_flow(scene({20, 30}, {150, 90}), scene({32, 30}, {162, 90}));
    const auto at = [&](double x, double y) {
        return static_cast<std::size_t>(y / flow.cell) * static_cast<std::size_t>(flow.grid.width) +
               static_cast<std::size_t>(x / flow.cell);
    };
    // Given a pan by 12 px: the left 12 px and half a patch are gone in the second picture.
    CHECK_FALSE(flow.is_reliable[at(5, 90)]);
    CHECK_FALSE(flow.is_reliable[at(13, 90)]);
    CHECK(flow.is_reliable[at(40, 90)]);
    CHECK(flow.vectors[at(60, 40)].x == doctest::Approx(-12).epsilon(0.05));
}

TEST_CASE("bare ground in noise does not move, whatever the flow says of it") {
    // Given a grey picture with a band of texture, all still, in independent noise.
    cv::Mat ground(90, 160, CV_8UC1, cv::Scalar(120));
    texture()(cv::Rect(0, 0, 160, 30)).copyTo(ground.rowRange(0, 30));
    cv::RNG random(9);
    const auto seen = [&] {
        cv::Mat noise(ground.size(), CV_16SC1);
        random.fill(noise, cv::RNG::NORMAL, 0, 4);
        cv::Mat sum;
        ground.convertTo(sum, CV_16SC1);
        sum += noise;
        sum.convertTo(sum, CV_8UC1);
        return sum;
    };
    for (int i = 0; i < 5; ++i) {
        const cv::Mat before = seen();
        double strongest = 0;
        cv::minMaxLoc(motion_contrast(before, seen()).map, nullptr, &strongest);
        CHECK(strongest < 0.2);
    }
}

TEST_CASE("a light that goes up is no motion") {
    const cv::Mat before = scene({20, 30}, {150, 90}) * 0.7;
    const cv::Mat after = before * 1.15;
    CHECK(cv::mean(motion_contrast(before, after).map)[0] < 0.1);
}

TEST_CASE("votes count by their weight") {
    const std::vector<Vec2> vectors{{3, 1}, {3, 1}, {3, 1}, {-8, 5}};
    const std::vector<double> weights{1, 1, 1, 9};
    CHECK(voted_motion(vectors) == Vec2{3, 1});
    CHECK(voted_motion(vectors, weights) == Vec2{-8, 5});
}

TEST_CASE("what comes into a panned picture at its edge is no motion") {
    const MotionContrast found = motion_contrast(scene({20, 30}, {150, 90}), scene({29, 30}, {159, 90}));
    double strongest = 0;
    cv::minMaxLoc(found.map(cv::Rect(304, 0, 16, 180)), nullptr, &strongest);
    CHECK(strongest < 0.05);
}

TEST_CASE("a zoom is no subject, and to the paper's letter it was") {
    const cv::Mat before = scene({20, 30}, {150, 90});
    cv::Mat after;
    cv::warpAffine(before, after, cv::getRotationMatrix2D({160, 90}, 0, 1.03), before.size(),
                   cv::INTER_LINEAR, cv::BORDER_REFLECT);
    CHECK(cv::mean(motion_contrast(before, after, MotionMethod::background).map)[0] < 0.1);
    CHECK(cv::mean(motion_contrast(before, after, MotionMethod::voted_pan).map)[0] > 0.15);
}

TEST_CASE("to the paper's letter the least motion counts 1, ours calls it noise") {
    // Given a still picture in which a disc moves by half a pixel.
    const cv::Mat before = scene({20, 30}, {150, 90});
    cv::Mat after = before.clone();
    const cv::Matx23d half_a_pixel(1, 0, 0.5, 0, 1, 0);
    cv::Mat shifted;
    cv::warpAffine(before, shifted, half_a_pixel, before.size());
    cv::Mat mask = cv::Mat::zeros(before.size(), CV_8UC1);
    cv::circle(mask, {150, 90}, 24, 255, cv::FILLED);
    shifted.copyTo(after, mask);
    double letter = 0;
    double ours = 0;
    cv::minMaxLoc(motion_contrast(before, after, MotionMethod::voted_pan).map, nullptr, &letter);
    cv::minMaxLoc(motion_contrast(before, after, MotionMethod::background).map, nullptr, &ours);
    CHECK(letter > 0.9);
    CHECK(ours < 0.6);
}

TEST_CASE("pictures too small to track have no motion") {
    CHECK(cv::countNonZero(
              motion_contrast(cv::Mat::zeros(3, 5, CV_8UC1), cv::Mat::zeros(3, 5, CV_8UC1)).map) == 0);
}
