// Real and hostile files, where they are: nothing is checked without them.

#include "analyzer/film/frame_reader.hpp"
#include "base/state/media_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <chrono>
#include <filesystem>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

namespace fs = std::filesystem;

const fs::path media = VITRINE_MEDIA;
constexpr int whole_photo = 4096;  // px: not shrunk

std::vector<std::string> files_under(const char* folder) {
    std::vector<std::string> files;
    if (!fs::is_directory(media / folder)) {
        MESSAGE("not here: the media folder ", std::string(folder));
        return files;
    }
    for (const auto& entry : fs::recursive_directory_iterator(media / folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
}

struct Outcome {
    MediaState state = MediaState::ready;
    std::string reason;
    int frames = 0;
    MediaInfo info;
    cv::Mat last;
};

// Reads a medium to its end, of a long one the first thousand frames.
Outcome read(const std::string& path) {
    constexpr int enough = 1000;
    Outcome outcome;
    try {
        const auto source = open_media(path);
        while (const auto frame = source->next()) {
            outcome.last = frame->picture;
            if (++outcome.frames == enough) break;
        }
        outcome.info = source->info();
    } catch (const MediaError& error) {
        outcome.state = error.state();
        outcome.reason = error.what();
    }
    return outcome;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    const cv::Scalar mean = cv::mean(difference);
    return (mean[0] + mean[1] + mean[2]) / 3;
}

Outcome read_in(const char* name) {
    return fs::exists(media / name) ? read(media / name) : Outcome{};
}

// Codecs and containers that docs/operator.md does not name.
bool is_left_out(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    return name.starts_with("prores") || name.starts_with("dnxhd") || name.ends_with(".mpg") ||
           name.ends_with(".ogv");
}

// A reason as the operator reads it: some words, none of them a library's or a path.
bool is_plain(const std::string& reason) {
    if (reason.size() < 10 || reason.ends_with(' ') || reason.ends_with(':') || reason.ends_with('.'))
        return false;
    for (const char* foreign : {"/", "Vips", "heif", "lib", "::", "_", "0x", "Invalid", "corrupt", "stream."})
        if (reason.find(foreign) != std::string::npos) return false;
    return true;
}

}  // namespace

TEST_CASE("every codec, container and still format opens" * doctest::test_suite("real")) {
    for (const char* folder : {"codecs", "formats", "orientation"}) {
        for (const std::string& path : files_under(folder)) {
            CAPTURE(path);
            const Outcome outcome = read(path);
            if (path.ends_with("audio_only.m4a")) {
                CHECK(outcome.reason == "the file holds only sound");
                continue;
            }
            CAPTURE(outcome.reason);
            if (is_left_out(path)) {
                CHECK(outcome.state == MediaState::unsupported);
                CHECK(outcome.reason.ends_with("; H.264 in MP4 plays everywhere"));
                CHECK(is_plain(outcome.reason));
                continue;
            }
            CHECK(outcome.state == MediaState::ready);
            CHECK(outcome.frames > 0);
            const int longest = outcome.info.kind == MediaKind::photo ? 640 : 320;  // twice, for its faces
            CHECK(std::max(outcome.last.cols, outcome.last.rows) <= longest);
            const double aspect = static_cast<double>(outcome.info.width) / outcome.info.height;
            CHECK(std::abs(outcome.last.cols - aspect * outcome.last.rows) <= std::max(1.0, aspect));
        }
    }
}

TEST_CASE("all eight orientations of one photo are the same picture" * doctest::test_suite("real")) {
    const Outcome upright = read_in("orientation/Landscape_1.jpg");
    if (upright.frames == 0) return;
    for (int i = 2; i <= 8; ++i) {
        const Outcome turned = read_in(fmt::format("orientation/Landscape_{}.jpg", i).c_str());
        REQUIRE(turned.last.size() == upright.last.size());
        CHECK(mean_difference(turned.last, upright.last) < 12);  // the words on them differ
    }
}

TEST_CASE("one photo stored turned or mirrored is upright, stored whole but cropped is cropped" *
          doctest::test_suite("real")) {
    if (!fs::exists(media / "formats/kimono.avif")) return;
    const cv::Mat plain = open_media(media / "formats/kimono.avif", whole_photo)->next()->picture;
    for (const char* name :
         {"kimono.mirror-horizontal.avif", "kimono.rotate90.avif", "kimono.rotate270.avif"}) {
        CAPTURE(name);
        const cv::Mat other = open_media(media / "formats" / name, whole_photo)->next()->picture;
        REQUIRE(other.size() == plain.size());
        CHECK(mean_difference(other, plain) < 4);  // they were coded one by one
    }
    const cv::Mat part = open_media(media / "formats/kimono.crop.avif", whole_photo)->next()->picture;
    cv::Mat found;
    cv::matchTemplate(plain, part, found, cv::TM_SQDIFF_NORMED);
    double best = 1;
    cv::minMaxLoc(found, &best);
    CHECK(best < 0.01);
}

TEST_CASE("a turned film stands as the unturned one" * doctest::test_suite("real")) {
    const Outcome upright = read_in("codecs/khronos_rotation_0.mp4");
    if (upright.frames == 0) return;
    for (const char* name : {"90", "180", "270"}) {
        const Outcome turned = read_in(fmt::format("codecs/khronos_rotation_{}.mp4", name).c_str());
        REQUIRE(turned.last.size() == upright.last.size());
        CHECK(mean_difference(turned.last, upright.last) < 8);
    }
}

TEST_CASE("no hostile file crashes, hangs or is shown when it is not whole" * doctest::test_suite("real")) {
    for (const std::string& path : files_under("hostile")) {
        CAPTURE(path);
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = read(path);
        const auto took = std::chrono::steady_clock::now() - start;
        const bool is_answered = outcome.state != MediaState::ready || outcome.frames > 0;
        CHECK(is_answered);
        if (outcome.state != MediaState::ready) CHECK(is_plain(outcome.reason));
        if (took > std::chrono::seconds(5))
            MESSAGE(path, " took ", std::chrono::duration_cast<std::chrono::seconds>(took).count(), " s");
    }
}

TEST_CASE("what is cut short is waited for, what is a bomb is refused" * doctest::test_suite("real")) {
    if (!fs::is_directory(media / "hostile/made")) return;
    for (const char* name :
         {"jpeg_cut_10pct.jpg", "jpeg_cut_50pct.jpg", "jpeg_cut_99pct.jpg", "mp4_cut_in_mdat.mp4",
          "mp4_cut_before_moov.mp4", "zero.jpg", "nulls_64KiB.mp4"}) {
        CAPTURE(name);
        CHECK(read(media / "hostile/made" / name).state == MediaState::waiting);
    }
    for (const char* name : {"bomb_30000x30000_1bit.png", "jpeg_header_says_65500.jpg", "bmp_claims_huge.bmp",
                             "really_html.mp4", "playlist.m3u8", "sdp.sdp", "svg_billion_laughs.svg"}) {
        CAPTURE(name);
        CHECK(read(media / "hostile/made" / name).state == MediaState::unsupported);
    }
    for (const char* name :
         {"jpeg_tail_garbage.jpg", "really_jpeg.mp4", "really_mp4.jpg", "[brackets].jpg", "%s%n%x.jpg"}) {
        CAPTURE(name);
        CHECK(read(media / "hostile/made" / name).state == MediaState::ready);
    }
}
