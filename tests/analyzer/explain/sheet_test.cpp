#include "analyzer/explain/sheet.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <filesystem>
#include <string>

#include <unistd.h>

using namespace vitrine;
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
    evidence.picture = cv::Mat(180, 320, CV_8UC3, cv::Scalar(120, 120, 120));
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

}  // namespace

TEST_CASE("a sheet is read back as it was drawn, with the region on it") {
    const ShotEvidence evidence = grey_shot_with_region();
    MediaRecord record{.kind = MediaKind::photo, .state = MediaState::ready, .width = 320, .height = 180};
    record.shots.push_back(evidence.shot);
    const Scratch file;
    const Canvas sheet = drawn_sheet({.name = "drawn.png", .bytes = 1234}, record, {evidence});
    sheet.write_png(file.path);

    const cv::Mat pixels = read_back(file.path);

    CHECK(pixels.size() == sheet.picture().size());
    CHECK(pixels.cols > 7 * 200);
    cv::Mat grey;
    cv::cvtColor(pixels, grey, cv::COLOR_RGB2GRAY);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(grey, mean, deviation);
    CHECK(deviation[0] > 10);
    cv::Mat region_line;
    cv::inRange(pixels, cv::Scalar(250, 130, 0), cv::Scalar(255, 145, 8), region_line);
    CHECK(cv::countNonZero(region_line) > 300);
    // The line lies in the last of the seven columns only.
    CHECK(cv::countNonZero(region_line.colRange(0, pixels.cols * 6 / 7)) == 0);
}
