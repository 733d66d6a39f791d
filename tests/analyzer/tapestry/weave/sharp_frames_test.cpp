#include "analyzer/tapestry/weave/sharp_frames.hpp"

#include "analyzer/tapestry/weave/candidate_writer.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "tests/analyzer/tapestry/weave/drawn_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

namespace vitrine::analyzer {
namespace {

Film kept_film(const TemporaryDirectory& folder, cv::Size size) {
    DrawnSource source(size, 46, false);
    return gathered(source, folder.path, nullptr);
}

}  // namespace

TEST_CASE("keyframes are read again as tall as wanted, or as the film is") {
    const TemporaryDirectory folder;
    const Film film = kept_film(folder, {320, 240});
    const std::optional<SharpFrames> wanted = sharp_frames(*film.candidates, 187);
    REQUIRE(wanted);
    CHECK(wanted->brick_height == 186);
    CHECK(wanted->frame_size == 248);
    CHECK(sharp_frames(*film.candidates, 400)->brick_height == 240);
    CHECK_FALSE(sharp_frames(*film.candidates, 110));
    CHECK_FALSE(sharp_frames(*kept_film(folder, {64, 48}).candidates, 187));
}

TEST_CASE("only the keyframes of the finest level are read again, and the levels count them") {
    const TemporaryDirectory folder;
    const Film film = kept_film(folder, {320, 240});
    const std::vector<Keyframes> levels{{1, 7}, {1, 3, 4, 7}};
    CandidateWriter writer(nameless_file(folder.path), CandidateWriter::two_hours, 180);
    DrawnSource again({300, 225}, 46, false);
    read_sharp_frames(again, *film.candidates, levels.back(),
                      [&](const FilmFrame& frame) { writer.push(frame); });
    const cv::Rect active = active_in(*film.candidates, writer.frame());
    CHECK(active == cv::Rect(0, 0, 300, 225));
    const Film sharp = film_of(writer.finish(film.candidates->film(), {}, active), nullptr);

    CHECK(are_frames_of(*sharp.candidates, *film.candidates, levels.back()));
    CHECK_FALSE(are_frames_of(*sharp.candidates, *film.candidates, levels.front()));
    CHECK(sharp.candidates->brick() == cv::Size(240, 180));
    CHECK(sharp.candidates->keyframe(2).picture.size() == cv::Size(240, 180));
    CHECK(sharp_levels(levels) == std::vector<Keyframes>{{0, 3}, {0, 1, 2, 3}});
}

TEST_CASE("a sharp tapestry takes the place of the first one") {
    const TemporaryDirectory folder;
    const Film film = kept_film(folder, {64, 48});
    const RetargetSettings quick{.quality = TileQuality::on_demand};
    const std::filesystem::path beside = folder.path / "sharp";
    const auto write = [&](const PyramidSettings& settings, const std::string& tiles) {
        return PyramidWriter(folder.path, film, settings, run_in_order)
            .write({.path = "drawn"}, {.folder = tiles, .levels = {{0, 4}}});
    };
    CHECK_FALSE(write({.retarget = quick, .is_last = false}, new_tile_folder(folder.path)).is_complete);
    std::filesystem::create_directories(beside);
    CHECK(write({.retarget = quick, .index = beside}, "tiles-1-sharp").is_complete);
    CHECK_FALSE(read_tapestry(folder.path).is_complete);
    CHECK(read_tapestry(folder.path).folder == "tiles-1");
    replace_tapestry(folder.path, beside);

    const Tapestry tapestry = read_tapestry(folder.path);
    CHECK(tapestry.is_complete);
    CHECK(tapestry.folder == "tiles-1-sharp");
    CHECK(std::filesystem::exists(folder.path / tapestry.tile_name(0, 0)));
    CHECK(std::filesystem::exists(folder.path / "tiles-1"));  // a player may show it
    CHECK_FALSE(std::filesystem::exists(beside));
}

}  // namespace vitrine::analyzer
