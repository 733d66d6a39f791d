#include "bench/tapestry/study/searcher.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace vitrine::study {
namespace {

using std::chrono::nanoseconds;
using std::chrono::seconds;

constexpr int width = 60;  // px of a frame
constexpr int height = 36;

/// A frame of its own pattern, not alike to any other number's.
cv::Mat frame_of(int number) {
    cv::Mat small(6, 10, CV_8UC3);
    cv::RNG random(static_cast<std::uint64_t>(number) + 1);
    random.fill(small, cv::RNG::UNIFORM, 0, 255);
    cv::Mat frame;
    cv::resize(small, frame, {width, height}, 0, 0, cv::INTER_NEAREST);
    return frame;
}

/// Frames 0 to `frames` side by side, one for each second of the film.
SearchedLevel filmstrip(int frames, int every) {
    SearchedLevel level{.picture = cv::Mat(height, frames / every * width, CV_8UC3),
                        .frame = {width, height},
                        .moment_at = [every](cv::Point at) { return seconds(at.x / width * every); },
                        .x_at =
                            [frames, every](nanoseconds time) {
                                const auto second = std::chrono::duration_cast<seconds>(time).count();
                                const auto x = static_cast<int>(second) / every * width + width / 2;
                                return std::clamp(x, 0, frames / every * width - 1);
                            }};
    for (int i = 0; i < frames; i += every)
        frame_of(i).copyTo(level.picture(cv::Rect(i / every * width, 0, width, height)));
    return level;
}

SoughtScene scene_at(int second) {
    return {.frame = frame_of(second), .shot_begin = seconds(second), .shot_end = seconds(second + 1)};
}

}  // namespace

TEST_CASE("a frame differs from none but its own place, and a little shift counts for nothing") {
    const SearchedLevel level = filmstrip(4, 1);
    const cv::Mat found = differences(level.picture, frame_of(2));
    REQUIRE(found.size() == level.picture.size());
    const cv::Point middle(2 * width + width / 2, height / 2);
    CHECK(found.at<float>(middle) < 1);
    CHECK(found.at<float>(middle + cv::Point(4, 0)) < 1);
    CHECK(found.at<float>(middle - cv::Point(width, 0)) > 30);
    CHECK(found.at<float>(0, 0) > 30);
}

TEST_CASE("a frame in view costs one click, one beyond the view the drags to it as well") {
    const SearchedInterface interface {
        .levels = {filmstrip(20, 1)}, .screen_width = 5 * width, .duration = seconds(20)
    };
    CHECK(count_steps(interface, scene_at(3)) == 1);
    CHECK(count_steps(interface, scene_at(12)) == 3);
}

TEST_CASE("a frame that only a finer level shows costs a zoom, and the drags to it") {
    const SearchedInterface interface {
        .levels = {filmstrip(16, 4), filmstrip(16, 1)}, .screen_width = 4 * width, .duration = seconds(16)
    };
    CHECK(count_steps(interface, scene_at(4)) == 1);
    const int finer = count_steps(interface, scene_at(6));
    CHECK(finer >= 2);
    CHECK(finer < 14);
}

TEST_CASE("a frame that was clicked in vain is not clicked again, though its cell is wider than itself") {
    // The frame of second 0 is shown three times as wide as it is; the sought shot looks the same and is
    // elsewhere.
    SearchedLevel level = filmstrip(8, 1);
    level.moment_at = [](cv::Point at) { return seconds(at.x / width / 3 * 3); };
    level.x_at = [](nanoseconds time) {
        return static_cast<int>(std::chrono::duration_cast<seconds>(time).count()) * width + 1;
    };
    const SearchedInterface interface {
        .levels = {level}, .screen_width = 8 * width, .duration = seconds(8)
    };
    SoughtScene scene = scene_at(2);
    scene.shot_begin = seconds(5);
    scene.shot_end = seconds(6);
    CHECK(count_steps(interface, scene) < 12);
}

TEST_CASE("without pictures the longest stretch is halved again and again") {
    const SearchedInterface interface {
        .levels = {{.picture = {},
                    .frame = {1, 1},
                    .moment_at = [](cv::Point) { return nanoseconds(0); },
                    .x_at = [](nanoseconds) { return 0; }}},
        .screen_width = 100, .duration = seconds(16)
    };
    CHECK(count_steps(interface, scene_at(8)) == 1);
    CHECK(count_steps(interface, scene_at(4)) == 2);
    CHECK(count_steps(interface, scene_at(12)) == 3);
    const SoughtScene none{.frame = frame_of(1), .shot_begin = seconds(20), .shot_end = seconds(21)};
    CHECK(count_steps(interface, none) == max_steps);
}

}  // namespace vitrine::study
