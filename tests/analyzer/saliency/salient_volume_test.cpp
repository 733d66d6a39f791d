#include "analyzer/saliency/salient_volume.hpp"

#include "analyzer/saliency/drift.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

SaliencyMap one_pixel(int x, int y) {
    SaliencyMap map = SaliencyMap::zeros(3, 3, CV_32FC1);
    map.at<float>(y, x) = 1;
    return map;
}

/// A disc of radius 6 about `start` that moves by `velocity` a second, 8 frames a second, on a faint
/// background.
std::vector<SalientFrame> moving_disc(Vec2 start, Vec2 velocity, int count) {
    std::vector<SalientFrame> frames;
    for (int i = 0; i < count; ++i) {
        const double time = i / 8.0;
        const Vec2 at = start + velocity * time;
        SaliencyMap map(90, 160, CV_32FC1, cv::Scalar(0.01));
        cv::circle(map, cv::Point2d(at.x, at.y), 6, 1, cv::FILLED, cv::LINE_8);
        frames.push_back({.map = map, .time = time, .global_motion = {}});
    }
    return frames;
}

}  // namespace

TEST_CASE("eq. 3.3 adds each frame moved by its number times the skew") {
    // Given a pixel that moves one to the right a frame, so that S_f(i + f, j) is at (0, 1) in all three.
    const std::vector<SalientFrame> frames{
        {one_pixel(0, 1), 0, {}}, {one_pixel(1, 1), 1, {}}, {one_pixel(2, 1), 2, {}}};
    const SaliencyMap along = accumulated(frames, {1, 0});
    CHECK(along.at<float>(1, 0) == 3);
    CHECK(cv::sum(along)[0] == 3);
    const SaliencyMap still = accumulated(frames, {0, 0});
    CHECK(still.at<float>(1, 0) == 1);
    CHECK(still.at<float>(1, 2) == 1);
}

TEST_CASE("a shift by half a pixel divides a value between two") {
    const std::vector<SalientFrame> frames{{one_pixel(1, 1), 0.5, {}}};
    const SaliencyMap map = accumulated(frames, {1, 0});
    CHECK(map.at<float>(1, 0) == doctest::Approx(0.5));
    CHECK(map.at<float>(1, 1) == doctest::Approx(0.5));
}

TEST_CASE("the box of half the mass leaves the weaker half out") {
    SaliencyMap map = SaliencyMap::zeros(3, 3, CV_32FC1);
    map.at<float>(0, 2) = 3;
    map.at<float>(2, 0) = 2;
    CHECK(half_mass_box(map) == Box{{2, 0}, {3, 1}});
    CHECK(half_mass_box(SaliencyMap::zeros(3, 3, CV_32FC1)) == Box{{0, 0}, {3, 3}});
}

TEST_CASE("a disc that moves steadily gives its motion as the drift") {
    const Vec2 velocity{20, -6};
    const std::vector<SalientFrame> frames = moving_disc({40, 50}, velocity, 16);
    const Vec2 drift = found_drift(frames, 2, DriftMode::smallest_area);
    CHECK(std::abs(drift.x - velocity.x) < 1);
    CHECK(std::abs(drift.y - velocity.y) < 1);
}

TEST_CASE("a subject that stands still, or hardly moves, gets no drift") {
    CHECK(found_drift(moving_disc({80, 45}, {0, 0}, 16), 2, DriftMode::smallest_area) == Vec2{});
    CHECK(found_drift(moving_disc({80, 45}, {1, 1}, 16), 2, DriftMode::smallest_area) == Vec2{});
    CHECK(found_drift(moving_disc({80, 45}, {40, 0}, 1), 0, DriftMode::smallest_area) == Vec2{});
}

TEST_CASE("what the flow measured is the drift, and that of the background where it carries the subject") {
    std::vector<SalientFrame> frames = moving_disc({40, 50}, {20, -6}, 16);
    for (SalientFrame& frame : frames) {
        frame.global_motion = {20.4, -6.1};
        frame.subject_motion = {19, -7};
    }
    const Vec2 carried = found_drift(frames, 2, DriftMode::smallest_area);
    CHECK(carried.x == doctest::Approx(20.4));
    CHECK(carried.y == doctest::Approx(-6.1));
    for (SalientFrame& frame : frames)
        frame.global_motion = {};
    const Vec2 own = found_drift(frames, 2, DriftMode::smallest_area);
    CHECK(own.x == doctest::Approx(19));
    CHECK(own.y == doctest::Approx(-7));
}

TEST_CASE("a motion that would spread the saliency is no drift, as a river's between its banks") {
    std::vector<SalientFrame> frames = moving_disc({80, 45}, {0, 0}, 16);
    for (SalientFrame& frame : frames)
        frame.subject_motion = {25, 0};
    CHECK(found_drift(frames, 2, DriftMode::smallest_area) == Vec2{});
}

TEST_CASE("a camera that shakes without going anywhere gives no drift") {
    std::vector<SalientFrame> frames = moving_disc({80, 45}, {0, 0}, 16);
    for (std::size_t i = 0; i < frames.size(); ++i)
        frames[i].global_motion = frames[i].subject_motion = {i % 4 < 2 ? 60.0 : -60.0, 0};
    CHECK(found_drift(frames, 2, DriftMode::smallest_area) == Vec2{});
}

TEST_CASE("however fast the subject, all frames keep 60 % of each side in common") {
    for (const DriftMode mode : {DriftMode::smallest_area, DriftMode::box_centres}) {
        const Vec2 drift = found_drift(moving_disc({20, 45}, {60, 0}, 16), 2, mode);
        const Box common = common_part({160, 90}, drift, 2);
        CHECK(common.width() >= 0.6 * 160 - 1e-6);
        CHECK(common.height() >= 0.6 * 90 - 1e-6);
    }
}

TEST_CASE("a subject that the network saw once is carried along by the motion of the salient part") {
    // Given a subject that stands, and moves on by 40 px a second; the network looked at one frame in the
    // middle.
    for (const double speed : {0.0, 40.0}) {
        std::vector<SalientFrame> frames = moving_disc({50, 45}, {speed, 0}, 9);
        for (SalientFrame& frame : frames)
            frame.subject_motion = {speed, 0};
        CHECK(subject_volume(frames, {}).empty());
        frames[4].subject = frames[4].map.clone();
        const SaliencyMap still = subject_volume(frames, {});
        for (std::size_t i = 0; i < frames.size(); ++i)
            CHECK(still.at<float>(45, static_cast<int>(50 + speed * frames[i].time)) > 0.9F);
        CHECK(still.at<float>(45, 120) < 0.1F);
        // When the shot drifts with the subject, it stays at its first place.
        const SaliencyMap along = subject_volume(frames, {speed, 0});
        CHECK(along.at<float>(45, 50) > 0.9F);
        CHECK(along.at<float>(45, 75) < 0.1F);
    }
}
