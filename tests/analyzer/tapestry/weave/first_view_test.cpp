#include "analyzer/tapestry/weave/first_view.hpp"

#include "base/media/still_picture.hpp"
#include "tests/analyzer/tapestry/weave/drawn_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

namespace vitrine::analyzer {
namespace {

const cv::Size brick(160, 100);

cv::Vec3b colour_of(int number) {
    return {static_cast<std::uint8_t>(40 * number), 90, static_cast<std::uint8_t>(250 - 30 * number)};
}

Keyframe plain_keyframe(int number) {
    return {.picture = cv::Mat(brick, CV_8UC3, cv::Scalar(colour_of(number))), .faces = {}, .region = {}};
}

int distance(const cv::Vec3b& a, const cv::Vec3b& b) {
    int largest = 0;
    for (int channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(a[channel] - b[channel]));
    return largest;
}

}  // namespace

TEST_CASE("each brick of a plain strip stands in its place, and nothing is left black") {
    for (const int count : {1, 2, 3, 6}) {
        CAPTURE(count);
        const Brickwork brickwork{.keyframes = count, .brick = brick};
        const cv::Mat strip = plain_strip(brickwork, plain_keyframe);
        REQUIRE(strip.size() == cv::Size(brickwork.width(), 150));
        for (int number = 0; number < count && count > 1; ++number) {
            const cv::Rect place = brickwork.place(number);
            const int y = number % 2 == 0 ? 37 : 112;
            for (const int x : {place.x + 12, place.x + 80, place.x + 148})
                CHECK(distance(strip.at<cv::Vec3b>(y, x), colour_of(number)) <= 1);
        }
        for (int y = 0; y < strip.rows; ++y)
            for (int x = 0; x < strip.cols; ++x)
                REQUIRE(strip.at<cv::Vec3b>(y, x)[1] >= 88);
    }
}

TEST_CASE("a plain brick keeps what matters in its picture") {
    const auto keyframe = [](int) {
        Keyframe one = plain_keyframe(0);
        one.picture.rowRange(80, 100).setTo(cv::Scalar(0, 255, 255));
        one.region = {{20, 80}, {140, 80}, {140, 100}, {20, 100}};
        return one;
    };
    const cv::Mat strip = plain_strip({.keyframes = 4, .brick = brick}, keyframe);
    int rows = 0;
    for (int y = 0; y < 75; ++y)
        rows += strip.at<cv::Vec3b>(y, 80)[1] > 160 ? 1 : 0;
    CHECK(rows >= 18);
}

TEST_CASE("a first view has one level of at most 24 keyframes that show a picture, and more follows") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 301, false);
    const Film film = gathered(source, folder.path, nullptr);
    write_first_view(folder.path, {.path = "drawn", .bytes = 7, .mtime_ns = 8}, "tiles-1-first", film);
    const Tapestry read = read_tapestry(folder.path);

    CHECK(read.path == "drawn");
    CHECK(read.bytes == 7);
    CHECK_FALSE(read.is_complete);
    CHECK(read.duration == film.duration);
    REQUIRE(read.levels.size() == 1);
    CHECK(read.levels[0].keyframes.size() == 24);
    CHECK(read.kept.times.size() == film.candidates->signatures().size());
    CHECK(read.digits.width > 0);
    int width = 0;
    for (int tile = 0; tile < read.tiles(0); ++tile)
        width += load_still((folder.path / read.tile_name(0, tile)).string(), 4000, 4000).width;
    CHECK(width == read.levels[0].width);
}

TEST_CASE("a first view shows the moments that a person has chosen, and none that are struck") {
    const TemporaryDirectory folder;
    DrawnSource source({64, 64}, 301, false);
    const Film film = gathered(source, folder.path, nullptr);
    using std::chrono::seconds;
    write_first_view(folder.path, {.path = "drawn", .choice = "ab"}, "tiles-1-first", film,
                     {.keyframes = {seconds(7)}, .struck = {seconds(2)}});
    const Tapestry read = read_tapestry(folder.path);
    CHECK(read.choice == "ab");
    CHECK(std::ranges::count(read.levels[0].keyframes, seconds(7)) == 1);
    for (const auto time : read.levels[0].keyframes)
        CHECK(std::chrono::abs(time - seconds(2)) > strike_reach);
    CHECK(first_keyframes(*film.candidates, 24, {.keyframes = {seconds(1)}, .is_only = true}).size() == 1);
}

TEST_CASE("a first view of a black film, or of one frame, is one all the same") {
    for (const int frames : {1, 60}) {
        const TemporaryDirectory folder;
        DrawnSource source({64, 48}, frames, true);
        const Film film = gathered(source, folder.path, nullptr);
        write_first_view(folder.path, {.path = "drawn"}, "tiles-1-first", film);
        CHECK_FALSE(read_tapestry(folder.path).levels[0].keyframes.empty());
    }
}

}  // namespace vitrine::analyzer
