#include "analyzer/explain/sheet.hpp"

#include "base/system/unique_fd.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <chrono>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <unistd.h>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

/// A file that is gone when the test is.
struct Scratch {
    std::string path =
        (fs::temp_directory_path() / ("vitrine-sheet-" + std::to_string(getpid()) + ".png")).string();

    ~Scratch() { fs::remove(path); }
};

ShotEvidence grey_shot_with_region() {
    ShotEvidence evidence{.samples = 1};
    for (const int second : {0, 1, 2}) {
        evidence.frames.push_back({.picture = cv::Mat(180, 320, CV_8UC3, cv::Scalar(120, 120, 120)),
                                   .time = std::chrono::seconds(second),
                                   .faces = {}});
    }
    evidence.image = SaliencyMap(90, 160, CV_32FC1, cv::Scalar(0.5));
    evidence.face = SaliencyMap::zeros(90, 160, CV_32FC1);
    evidence.combined = evidence.image.clone();
    evidence.volume = evidence.image.clone();
    evidence.shot.region.polygon = {{80, 40}, {240, 40}, {240, 140}, {80, 140}};
    return evidence;
}

/// The PNG's pixels, RGB.
cv::Mat read_back(const std::string& path) {
    VipsImage* image = vips_image_new_from_file(path.c_str(), nullptr);
    REQUIRE(image != nullptr);
    CHECK(vips_image_get_bands(image) == 3);
    std::size_t bytes = 0;
    void* data = vips_image_write_to_memory(image, &bytes);
    REQUIRE(data != nullptr);
    cv::Mat result =
        cv::Mat(vips_image_get_height(image), vips_image_get_width(image), CV_8UC3, data).clone();
    g_free(data);
    g_object_unref(image);
    return result;
}

/// The number of pixels that have about this colour, RGB.
int line_pixels(const cv::Mat& pixels, cv::Scalar colour, double tolerance = 8) {
    cv::Mat found;
    cv::inRange(pixels, colour - cv::Scalar::all(tolerance), colour + cv::Scalar::all(tolerance), found);
    return cv::countNonZero(found);
}

}  // namespace

TEST_CASE("a sheet is read back as it was drawn, with the region on it") {
    const ShotEvidence evidence = grey_shot_with_region();
    MediaRecord record{.kind = MediaKind::photo, .state = MediaState::ready, .width = 320, .height = 180};
    record.shots.push_back(evidence.shot);
    const Scratch file;
    const Canvas sheet = drawn_sheet({.name = "drawn.png", .bytes = 1234}, record, {evidence});
    sheet.write_png(UniqueFd(::open(file.path.c_str(), O_WRONLY | O_CREAT, 0600)).get());

    const cv::Mat pixels = read_back(file.path);

    CHECK(pixels.size() == sheet.picture().size());
    CHECK(pixels.cols >= 1100);
    cv::Mat grey;
    cv::cvtColor(pixels, grey, cv::COLOR_RGB2GRAY);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(grey, mean, deviation);
    CHECK(deviation[0] > 10);
    CHECK(line_pixels(pixels, {255, 138, 0}) > 300);
    // No map is drawn on.
    CHECK(line_pixels(pixels.colRange(pixels.cols * 2 / 3, pixels.cols).rowRange(140, pixels.rows),
                      {255, 138, 0}) == 0);
}

TEST_CASE("the sheet of a film shows the region going along, and the letter's to compare") {
    ShotEvidence evidence = grey_shot_with_region();
    evidence.shot.end = std::chrono::seconds(2);
    MediaRecord record{.kind = MediaKind::film, .state = MediaState::ready, .width = 320, .height = 180};
    record.duration = std::chrono::seconds(2);
    record.shots.push_back(evidence.shot);
    constexpr double thin = 70;  // such a line is blended with what it is drawn on
    const auto below_the_legend = [&](const ShotEvidence& row) {
        cv::Mat result;
        cv::cvtColor(drawn_sheet({.name = "drawn.mp4"}, record, {row}).picture(), result, cv::COLOR_BGR2RGB);
        return result.rowRange(250, result.rows).clone();
    };

    const cv::Mat still = below_the_legend(evidence);
    CHECK(line_pixels(still, {0, 200, 224}) == 0);
    CHECK(line_pixels(still, {240, 58, 155}, thin) == 0);

    evidence.shot.region.drift = {30, 0};
    evidence.letter.polygon = {{4, 4}, {310, 4}, {310, 170}, {4, 170}};
    record.shots = {evidence.shot};
    const cv::Mat moving = below_the_legend(evidence);
    CHECK(line_pixels(moving, {0, 200, 224}) > 60);
    CHECK(line_pixels(moving, {240, 58, 155}, thin) > 300);
    CHECK(cv::norm(still, moving, cv::NORM_L1) > 0);
}
