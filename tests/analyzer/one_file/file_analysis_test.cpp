#include "analyzer/one_file/file_analysis.hpp"

#include "analyzer/explain/canvas.hpp"
#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analysed_file.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "base/media/still_picture.hpp"
#include "base/state/tapestry.hpp"
#include "base/system/unique_fd.hpp"
#include "tests/analyzer/film/drawn_film.hpp"
#include "tests/analyzer/origin/drawn_motion_photo.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

/// A photo of 1000 x 600 px with a disc and two specks, gone when the test is.
struct Photo {
    std::string path =
        (fs::temp_directory_path() / ("vitrine-photo-" + std::to_string(getpid()) + ".png")).string();

    Photo() {
        cv::Mat picture(600, 1000, CV_8UC3, cv::Scalar(200, 190, 180));
        cv::circle(picture, {600, 260}, 90, cv::Scalar(40, 60, 240), cv::FILLED, cv::LINE_AA);
        cv::circle(picture, {60, 540}, 12, cv::Scalar(40, 60, 240), cv::FILLED, cv::LINE_AA);
        cv::circle(picture, {940, 60}, 12, cv::Scalar(40, 60, 240), cv::FILLED, cv::LINE_AA);
        Canvas canvas(picture.cols, picture.rows, 0);
        canvas.place(picture, {});
        canvas.write_png(UniqueFd(::open(path.c_str(), O_WRONLY | O_CREAT, 0600)).get());
    }

    Photo(const Photo&) = delete;
    Photo& operator=(const Photo&) = delete;

    ~Photo() { fs::remove(path); }
};

Settings settings_without_faces(RegionMode region) {
    Settings settings;
    settings.analyzer.face_model.clear();
    settings.analyzer.face_cascade.clear();
    settings.analyzer.region = region;
    return settings;
}

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("region = hull is the paper's letter in every stage, not the hull of our saliency") {
    const Photo photo;
    AnalysisSettings letter = paper_mode();
    letter.face_cascade.clear();
    AnalysisSettings hull_of_ours;
    hull_of_ours.face_cascade.clear();
    hull_of_ours.region.mode = RegionMode::hull;

    const MediaRecord found = analyse_file(photo.path, settings_without_faces(RegionMode::hull));

    REQUIRE(found.shots.size() == 1);
    const Polygon expected = analyze(*open_media(photo.path), letter).shots.at(0).region.polygon;
    CHECK(found.shots[0].region.polygon == expected);
    CHECK(analyze(*open_media(photo.path), hull_of_ours).shots.at(0).region.polygon != expected);
}

TEST_CASE("a photo is looked at with twice the pixels of a film's frame, for its faces") {
    const Photo photo;
    const auto source = open_media(photo.path, 320);
    CHECK(source->next()->picture.size() == cv::Size(640, 384));
}

TEST_CASE("the film inside a motion photo is put into the store, and one that is missing is named") {
    const TemporaryDirectory folder;
    const std::string film =
        content_of(written(folder, {.caps = "format=I420,width=64,height=48",
                                    .chain = "x264enc ! mp4mux",
                                    .picture = std::vector<std::uint8_t>(64 * 48 * 3 / 2, 90)}));
    const Photo photo;
    save_smaller(photo.path, 400, (folder.path / "plain.jpg").string());
    const std::string plain = content_of(folder.path / "plain.jpg");
    const std::string moving = with_xmp(plain, motion_photo_xmp(film.size()));
    Settings settings = settings_without_faces(RegionMode::min_area);
    settings.media.root = folder.path;
    settings.state.directory = folder.path / "state";

    const MediaRecord whole =
        analyse_file(folder.write("whole.jpg", moving + film), settings, {.stored = true});
    REQUIRE(whole.film);
    CHECK(whole.reason.empty());
    CHECK(whole.kind == MediaKind::photo);
    CHECK(whole.shots.size() == 1);
    CHECK(whole.film->width == 64);
    CHECK(whole.film->is_there());
    CHECK(fs::exists(folder.path / "state" / "store" / whole.film->shot.stored->file));
    CHECK_FALSE(fs::exists(folder.path / "state" / "store" /
                           fs::path(whole.film->shot.stored->file).parent_path() / "inner.mp4"));

    const MediaRecord cut = analyse_file(folder.write("cut.jpg", moving), settings, {.stored = true});
    CHECK(cut.state == MediaState::ready);
    CHECK_FALSE(cut.film);
    CHECK(cut.reason == "its film is not played: there is none where the photo says");
    CHECK(analyse_file(folder.path / "plain.jpg", settings, {.stored = true}).reason.empty());
}

TEST_CASE("the one decoding of a film leaves its frames for its tapestry, where that is lacking") {
    const TemporaryDirectory folder;
    const std::string film = written(folder, {.caps = "format=I420,width=64,height=48",
                                              .picture = std::vector<std::uint8_t>(64 * 48 * 3 / 2, 90)});
    Settings settings = settings_without_faces(RegionMode::min_area);
    settings.media.root = folder.path;
    settings.state.directory = folder.path / "state";
    const fs::path kept = tapestry_folder(settings.state.directory, "film");

    (void)analyse_file(film, settings);
    CHECK_FALSE(kept_frames(kept));
    const MediaRecord record = analyse_file(film, settings, {.frames = true});
    REQUIRE(record.state == MediaState::ready);
    const Film frames = film_of(std::move(*kept_frames(kept)), nullptr);
    CHECK(frames.candidates->signatures().size() == 1);
    CHECK(frames.candidates->content() == FilmContent{.bytes = record.bytes, .mtime_ns = record.mtime_ns});
    CHECK(frames.duration == record.duration);

    remove_kept_frames(kept);
    write_tapestry(kept, {.path = "film",
                          .bytes = record.bytes,
                          .mtime_ns = record.mtime_ns,
                          .is_complete = true,
                          .folder = "tiles-1",
                          .height = 150,
                          .tile_width = 512,
                          .brick_width = 178,
                          .levels = {}});
    (void)analyse_file(film, settings, {.frames = true});
    CHECK_FALSE(kept_frames(kept));
}

TEST_CASE("the word of the setting chooses the network that looks") {
    Settings::Analyzer settings;
    settings.saliency_model = "/large.onnx";
    settings.student_model = "/small.onnx";
    CHECK(analysis_settings(settings).saliency_model == "/large.onnx");
    CHECK(analysis_settings(settings).spare_model == "/small.onnx");
    CHECK_FALSE(analysis_settings(settings).is_student);
    settings.saliency = SaliencyMethod::student;
    CHECK(analysis_settings(settings).saliency_model == "/small.onnx");
    CHECK(analysis_settings(settings).spare_model.empty());
    CHECK(analysis_settings(settings).is_student);
    settings.saliency = SaliencyMethod::plain;
    CHECK(analysis_settings(settings).saliency_model.empty());
    CHECK(analysis_settings(settings).spare_model.empty());
}
