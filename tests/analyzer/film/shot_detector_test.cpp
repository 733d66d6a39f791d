#include "analyzer/film/shot_detector.hpp"

#include "tests/analyzer/film/drawn_scenes.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::analyzer;
using std::chrono::milliseconds;

namespace {

const cv::Size size = scene_size;

}  // namespace

TEST_CASE("a cut parts two shots at the new shot's first frame") {
    const auto shots = shots_of(80, [](int i) { return i < 33 ? warm() : cold(); });
    CHECK(shots == std::vector{shot(0, 33, ShotEnd::cut), shot(33, 80, ShotEnd::end)});
}

TEST_CASE("a shot is given out soon after its end, not at the end of the film") {
    ShotDetector detector;
    int given_at = -1;
    for (int i = 0; i < 150 && given_at < 0; ++i)
        if (!detector.push({.picture = i < 50 ? warm() : cold(), .time = i * frame_time}).empty())
            given_at = i;
    CHECK(given_at > 50);
    CHECK(given_at < 120);
}

TEST_CASE("a flash does not end a shot") {
    const auto shots =
        shots_of(80, [](int i) { return i == 40 || i == 41 ? warm() + cv::Scalar(140, 140, 140) : warm(); });
    CHECK(shots == std::vector{shot(0, 80, ShotEnd::end)});
}

TEST_CASE("a pan over an unlike view is one shot") {
    cv::Mat view;
    cv::hconcat(std::vector{warm(), scene(3, {60, 130, 20}), cold(), scene(4, {90, 90, 90})}, view);
    const auto shots = shots_of(96, [&](int i) { return view(cv::Rect({i * 5, 0}, size)).clone(); });
    CHECK(shots == std::vector{shot(0, 96, ShotEnd::end)});
}

TEST_CASE("a dissolve belongs to neither of its shots") {
    const auto shots =
        shots_of(110, [](int i) { return mixed(warm(), cold(), std::clamp((i - 45) / 16.0, 0.0, 1.0)); });
    REQUIRE(shots.size() == 2);
    CHECK(shots[0].ends_with == ShotEnd::dissolve);
    CHECK(is_near(shots[0].end, 45, 4));
    CHECK(is_near(shots[1].begin, 61, 4));
    CHECK(shots[1].ends_with == ShotEnd::end);
}

TEST_CASE("a fade over black ends one shot and begins the next where it is over") {
    const auto shots = shots_of(140, [](int i) {
        if (i < 65)
            return mixed(warm(), cv::Mat::zeros(size, CV_8UC3), std::clamp((i - 40) / 20.0, 0.0, 1.0));
        return mixed(cv::Mat::zeros(size, CV_8UC3), cold(), std::clamp((i - 65) / 20.0, 0.0, 1.0));
    });
    REQUIRE(shots.size() == 2);
    CHECK(shots[0].ends_with == ShotEnd::fade);
    CHECK(is_near(shots[0].end, 45, 2));  // lit to three quarters
    CHECK(is_near(shots[1].begin, 80, 2));
}

TEST_CASE("a film that begins black begins its first shot where the picture stands") {
    const auto shots = shots_of(90, [](int i) {
        return mixed(cv::Mat::zeros(size, CV_8UC3), warm(), std::clamp((i - 10) / 20.0, 0.0, 1.0));
    });
    REQUIRE(shots.size() == 1);
    CHECK(is_near(shots[0].begin, 30, 5));
    CHECK(shots[0].end == 90 * frame_time);
}

TEST_CASE("the shot that follows a stretch too short to be seen begins with it") {
    const auto shots = shots_of(100, [](int i) {
        return i < 40 ? warm() : i < 49 ? scene(5, {20, 130, 60}) : cold();
    });
    CHECK(shots == std::vector{shot(0, 40, ShotEnd::cut), shot(40, 100, ShotEnd::end)});
}

TEST_CASE("two stretches shorter than a second are one shot") {
    const auto shots = shots_of(130, [](int i) {
        if (i < 40) return warm();
        return i < 60 ? scene(5, {20, 130, 60}) : i < 80 ? scene(10, {130, 130, 20}) : cold();
    });
    CHECK(shots ==
          std::vector{shot(0, 40, ShotEnd::cut), shot(40, 80, ShotEnd::cut), shot(80, 130, ShotEnd::end)});
}

TEST_CASE("a short stretch with transitions on both sides is a shot of its own") {
    const auto shots = shots_of(130, [](int i) {
        if (i < 40) return warm();
        return i < 55 || (i >= 63 && i < 80) ? black() : i < 63 ? scene(5, {20, 130, 60}) : cold();
    });
    CHECK(shots ==
          std::vector{shot(0, 40, ShotEnd::cut), shot(55, 63, ShotEnd::cut), shot(80, 130, ShotEnd::end)});
}

TEST_CASE("short stretches in a row are shown as one montage") {
    const std::vector short_scenes{scene(10, {20, 130, 60}), scene(11, {130, 130, 20}),
                                   scene(12, {60, 20, 130})};
    const auto shots = shots_of(100, [&](int i) {
        if (i < 30) return warm();
        return i < 60 ? short_scenes[static_cast<std::size_t>(i / 10 - 3)] : cold();
    });
    CHECK(shots ==
          std::vector{shot(0, 30, ShotEnd::cut), shot(30, 60, ShotEnd::cut), shot(60, 100, ShotEnd::end)});
}

TEST_CASE("a film of one colour is one shot, and one of a single frame too") {
    CHECK(shots_of(50, [](int) { return cv::Mat(cv::Mat::zeros(size, CV_8UC3)); }) ==
          std::vector{shot(0, 50, ShotEnd::end)});
    CHECK(shots_of(1, [](int) { return warm(); }) == std::vector{shot(0, 1, ShotEnd::end)});
    CHECK(ShotDetector().finish(milliseconds{0}).empty());
}

TEST_CASE("cuts are found by time whatever the frame rate") {
    for (const int rate : {5, 12, 60, 120}) {
        CAPTURE(rate);
        ShotDetector detector;
        std::vector<DetectedShot> shots;
        const std::chrono::nanoseconds step{1'000'000'000 / rate};
        for (int i = 0; i < 4 * rate; ++i)
            std::ranges::copy(detector.push({.picture = i < 2 * rate ? warm() : cold(), .time = i * step}),
                              std::back_inserter(shots));
        std::ranges::copy(detector.finish(4 * rate * step), std::back_inserter(shots));
        REQUIRE(shots.size() == 2);
        CHECK(shots[1].begin == 2 * rate * step);
    }
}
