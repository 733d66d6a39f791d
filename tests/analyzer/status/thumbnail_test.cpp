#include "analyzer/status/thumbnail.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <array>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

FilmFrame frame(const cv::Scalar& bgr, std::chrono::nanoseconds time = 0s) {
    return {.picture = cv::Mat(180, 320, CV_8UC3, bgr), .time = time};
}

/// A region over the left half of a picture four times as large as the frames.
MediaRecord record(std::chrono::nanoseconds begin = 0s, std::chrono::nanoseconds end = 0s) {
    return {.kind = end > 0s ? MediaKind::film : MediaKind::photo,
            .state = MediaState::ready,
            .width = 1280,
            .height = 720,
            .shots = {{.begin = begin,
                       .end = end,
                       .region = {.polygon = {{40, 40}, {640, 40}, {640, 680}, {40, 680}}, .drift = {}}}}};
}

struct Seen {
    int width = 0, height = 0;
    std::array<double, 3> middle_of_right{};  // RGB
    std::array<double, 3> on_outline{};
};

std::array<double, 3> pixel(VipsImage* image, int x, int y) {
    double* values = nullptr;
    int count = 0;
    REQUIRE(vips_getpoint(image, &values, &count, x, y, nullptr) == 0);
    REQUIRE(count == 3);
    const std::array<double, 3> rgb{values[0], values[1], values[2]};
    g_free(values);
    return rgb;
}

Seen seen(const fs::path& file) {
    REQUIRE(vips_init("test") == 0);
    VipsImage* image = vips_image_new_from_file(file.c_str(), nullptr);
    REQUIRE(image != nullptr);
    const Seen seen{.width = image->Xsize,
                    .height = image->Ysize,
                    .middle_of_right = pixel(image, 180, 67),
                    .on_outline = pixel(image, 120, 67)};
    g_object_unref(image);
    return seen;
}

}  // namespace

TEST_CASE("a thumbnail is small and has the region drawn where it lies") {
    const TemporaryDirectory directory;
    const fs::path file = directory.path / "thumbnails/a.jpg";
    Thumbnail thumbnail(file);
    thumbnail.add_frame(frame({200, 40, 40}));
    thumbnail.write(record());
    const Seen found = seen(file);
    CHECK(found.width == 240);
    CHECK(found.height == 135);
    CHECK(found.middle_of_right[2] > 150);  // blue, as the picture
    CHECK(found.on_outline[0] > 180);       // yellow, as the outline
    CHECK(found.on_outline[2] < 150);
    CHECK(fs::file_size(file) < 20'000);
}

TEST_CASE("a thumbnail has no bars") {
    const TemporaryDirectory directory;
    const fs::path file = directory.path / "a.jpg";
    Thumbnail thumbnail(file);
    thumbnail.add_frame(frame({200, 40, 40}));
    MediaRecord letterboxed = record();
    letterboxed.shots[0].picture = Box{{0, 80}, {1280, 640}};
    thumbnail.write(letterboxed);
    CHECK(seen(file).height == 105);
}

TEST_CASE("of a film the first frame of its first shot is shown, not what fades in before") {
    const TemporaryDirectory directory;
    const fs::path file = directory.path / "a.jpg";
    Thumbnail thumbnail(file);
    for (int i = 0; i < 100; ++i)
        thumbnail.add_frame(frame(i < 50 ? cv::Scalar(0, 0, 0) : cv::Scalar(40, 200, 40), i * 40ms));
    thumbnail.write(record(2s, 4s));
    CHECK(seen(file).middle_of_right[1] > 150);
    const auto time = fs::last_write_time(file);
    thumbnail.write(record(3s, 4s));
    CHECK(fs::last_write_time(file) == time);
}

TEST_CASE("without a shot, or where the disk is full, there is none and nothing fails") {
    const TemporaryDirectory directory;
    Thumbnail nothing(directory.path / "a.jpg");
    nothing.write({});
    CHECK_FALSE(fs::exists(directory.path / "a.jpg"));
    directory.write("b", "a file in the folder's place");
    Thumbnail full(directory.path / "b/a.jpg");
    full.add_frame(frame({200, 40, 40}));
    full.write(record());
    CHECK_FALSE(fs::exists(directory.path / "b/a.jpg"));
}
