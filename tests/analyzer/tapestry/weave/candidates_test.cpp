#include "analyzer/tapestry/weave/candidates.hpp"

#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "base/system/atomic_file.hpp"
#include "tests/analyzer/tapestry/weave/drawn_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <opencv2/imgproc.hpp>

#include <cstdlib>
#include <string>
#include <utility>

namespace vitrine::analyzer {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

}  // namespace

TEST_CASE("a film beyond the most frames keeps fewer a second, and no more memory") {
    const TemporaryDirectory folder;
    CandidateWriter writer(nameless_file(folder.path), 100);
    for (int i = 0; i < 280; ++i) {
        const int grey = i / 2;
        writer.push(
            {.picture = cv::Mat(4, 4, CV_8UC3, cv::Scalar::all(grey)), .time = milliseconds(500) * i});
    }
    const Film film =
        film_of(writer.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(1)}, {}), nullptr);
    const auto& frames = film.candidates->signatures();

    CHECK(film.duration == milliseconds(139'500) + std::chrono::nanoseconds(1));
    CHECK(frames.size() == 70);
    bool is_even = true;
    for (std::size_t i = 1; i < frames.size(); ++i)
        is_even &= frames[i].time - frames[i - 1].time == milliseconds(2000);
    CHECK(is_even);
    CHECK(frames.back().pixels[0] == 138);
    const cv::Mat picture = film.candidates->keyframe(69).picture;
    CHECK(cv::norm(picture, cv::Mat(picture.size(), CV_8UC3, cv::Scalar::all(138)), cv::NORM_INF) <= 1);
}

TEST_CASE("frames kept are those of a film gathered, and of no other file") {
    const TemporaryDirectory folder;
    const FilmContent content{.bytes = 5, .mtime_ns = -3};
    {
        KeptFrames frames(folder.path / "a", 1 << 20);
        for (DrawnSource source({64, 48}, 46, false); const auto frame = source.next();)
            frames.saw(*frame);
        CHECK_FALSE(kept_frames(folder.path / "a"));
        frames.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(9)}, content);
    }
    DrawnSource source({64, 48}, 46, false);
    const Film gathered_film = gathered(source, folder.path, nullptr);
    const Film kept_film = film_of(std::move(*kept_frames(folder.path / "a")), nullptr);
    CHECK(kept_film.candidates->content() == content);
    CHECK(kept_film.duration == seconds(9));
    REQUIRE(kept_film.candidates->signatures().size() == gathered_film.candidates->signatures().size());
    for (std::size_t i = 0; i < kept_film.candidates->signatures().size(); ++i) {
        const FrameSignature& kept = kept_film.candidates->signatures()[i];
        const FrameSignature& other = gathered_film.candidates->signatures()[i];
        CHECK((kept.time == other.time && kept.pixels == other.pixels));
    }
    remove_kept_frames(folder.path / "a");
    CHECK(std::filesystem::is_empty(folder.path / "a"));
}

TEST_CASE("frames of a film that breaks off or needs too much room are not kept") {
    const TemporaryDirectory folder;
    {
        KeptFrames broken(folder.path, 1 << 20);
        KeptFrames large(folder.path / "large", 100);
        for (DrawnSource source({64, 48}, 46, false); const auto frame = source.next();) {
            broken.saw(*frame);
            large.saw(*frame);
        }
        large.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(9)}, {});
        KeptFrames nowhere("/proc/nowhere", 100);
        nowhere.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(9)}, {});
    }
    CHECK_FALSE(kept_frames(folder.path));
    CHECK_FALSE(kept_frames(folder.path / "large"));
    CHECK(std::filesystem::is_empty(folder.path / "large"));
}

TEST_CASE("the bricks of a letterboxed film have no bars") {
    const TemporaryDirectory folder;
    CandidateWriter writer(nameless_file(folder.path));
    for (int i = 0; i < 20; ++i) {
        cv::Mat picture(180, 320, CV_8UC3, cv::Scalar::all(0));
        if (i != 3) picture.rowRange(20, 160) = cv::Scalar(40, 120 + 4 * i, 200);  // one is black
        writer.push({.picture = picture, .time = milliseconds(500) * i});
    }
    const Film film =
        film_of(writer.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(10)}, {}), nullptr);
    CHECK(film.candidates->brick() == brick_for({320, 138}));
    const cv::Mat brick = film.candidates->keyframe(0).picture;
    CHECK(brick.size() == film.candidates->brick());
    double darkest = 0;
    cv::minMaxLoc(brick.reshape(1).colRange(2, 3), &darkest, nullptr);
    CHECK(darkest > 150);
    CHECK(film.candidates->keyframe(3).picture.size() == film.candidates->brick());
}

TEST_CASE("a frame comes with its shot's region at its time, unless that is nearly all of the picture") {
    const TemporaryDirectory folder;
    CandidateWriter writer(nameless_file(folder.path));
    for (int i = 0; i < 6; ++i)
        writer.push(
            {.picture = cv::Mat(180, 320, CV_8UC3, cv::Scalar(40, 120, 200)), .time = milliseconds(500) * i});
    MediaRecord record{
        .kind = MediaKind::film, .width = 640, .height = 360, .duration = std::chrono::seconds(3)};
    record.shots.push_back({.begin = seconds(0),
                            .end = seconds(2),
                            .region = {.polygon = to_polygon({{100, 90}, {200, 270}}), .drift = {64, 0}}});
    record.shots.push_back({.begin = seconds(2),
                            .end = milliseconds(2500),
                            .region = {.polygon = to_polygon({{0, 0}, {640, 300}}), .drift = {}}});
    const Film film = film_of(writer.finish(record, {}), nullptr);

    REQUIRE(film.candidates->brick() == cv::Size(178, 100));
    const cv::Rect box = cv::boundingRect(film.candidates->keyframe(2).region);
    CHECK(std::abs(box.x - 164 * 178 / 640) <= 1);
    CHECK(std::abs(box.br().x - 264 * 178 / 640) <= 2);
    CHECK(std::abs(box.y - 25) <= 1);
    CHECK(film.candidates->keyframe(4).region.empty());
    CHECK(film.candidates->keyframe(5).region.empty());
}

TEST_CASE("the bricks of a shot that has bars of its own have none") {
    const TemporaryDirectory folder;
    CandidateWriter writer(nameless_file(folder.path));
    for (int i = 0; i < 8; ++i) {
        cv::Mat picture(180, 320, CV_8UC3, cv::Scalar(40, 120 + 4 * i, 200));
        if (i >= 4) picture.colRange(0, 40).setTo(cv::Scalar::all(0));
        if (i >= 4) picture.colRange(280, 320).setTo(cv::Scalar::all(0));
        writer.push({.picture = picture, .time = milliseconds(500) * i});
    }
    MediaRecord record{
        .kind = MediaKind::film, .width = 320, .height = 180, .duration = std::chrono::seconds(4)};
    record.shots.push_back({.begin = seconds(0), .end = seconds(2), .region = {}});
    record.shots.push_back(
        {.begin = seconds(2), .end = seconds(4), .region = {}, .picture = Box{{40, 0}, {280, 180}}});
    const Film film = film_of(writer.finish(record, {}), nullptr);
    for (const int number : {0, 6}) {
        CAPTURE(number);
        double darkest = 0;
        cv::minMaxLoc(film.candidates->keyframe(number).picture.reshape(1).colRange(2, 3), &darkest, nullptr);
        CHECK(darkest > 150);
    }
}

TEST_CASE("a file that is none of frames, or is cut short, is refused") {
    const TemporaryDirectory folder;
    CandidateWriter writer(nameless_file(folder.path));
    writer.push({.picture = cv::Mat(4, 4, CV_8UC3, cv::Scalar::all(9))});
    const UniqueFd whole = writer.finish({.kind = MediaKind::film, .duration = std::chrono::seconds(1)}, {});
    const std::string bytes = read_file("/proc/self/fd/" + std::to_string(whole.get()));
    const auto film = [&](const std::string& content) {
        return film_of(UniqueFd(::open(folder.write("frames", content).c_str(), O_RDONLY)), nullptr);
    };
    CHECK_NOTHROW(film(bytes));
    CHECK_THROWS(film(""));
    CHECK_THROWS(film(bytes.substr(1)));
    CHECK_THROWS(film(bytes.substr(0, bytes.size() - 1)));
    CHECK_THROWS(film(std::string(4000, 'x')));
}

TEST_CASE("a plan is read as it was written, for the same film and choice only") {
    const TemporaryDirectory folder;
    const PlanSubject subject{.content = {.bytes = 12, .mtime_ns = 34}};
    const WeavePlan plan{.folder = "tiles-3", .levels = {{0, 4}, {0, 2, 3, 4}}};
    CHECK_FALSE(read_plan(folder.path, subject, 5));
    write_plan(folder.path, subject, plan);
    CHECK(read_plan(folder.path, subject, 5) == plan);
    CHECK_FALSE(read_plan(folder.path, {.content = {.bytes = 12, .mtime_ns = 35}}, 5));
    CHECK_FALSE(read_plan(folder.path, {.content = subject.content, .choice = "ab12"}, 5));
    CHECK_FALSE(read_plan(folder.path, subject, 4));
    for (const char* bad :
         {"", "tiles-1\n", "../x\n0 1\n", "tiles-1\n1 0\n", "tiles-1\n0 1\n0 2 3\n", "tiles-1\n0 x\n"}) {
        CAPTURE(bad);
        folder.write("plan", std::string("vitrine-plan 2 12 34 - ") + bad);
        CHECK_FALSE(read_plan(folder.path, subject, 5));
    }
    remove_plan(folder.path);
    CHECK_FALSE(std::filesystem::exists(folder.path / "plan"));
}

}  // namespace vitrine::analyzer
