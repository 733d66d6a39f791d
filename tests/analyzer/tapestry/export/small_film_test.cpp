#include "analyzer/tapestry/export/small_film.hpp"

#include "analyzer/film/film_source.hpp"
#include "base/media/gst_ptr.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gst/app/gstappsrc.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace vitrine::analyzer {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::size_t pictures = 75;

/// A film of 25 plain grey pictures a second, each a little brighter than the one before.
std::string grey_film(const fs::path& path, int width, int height) {
    start_gstreamer();
    const std::string words = fmt::format(
        "appsrc name=in format=time caps=video/x-raw,format=I420,width={},height={},framerate=25/1"
        " ! avenc_ffv1 ! matroskamux ! filesink location={}",
        width, height, path.string());
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "in"));
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    const auto points = static_cast<std::size_t>(width * height);
    for (std::size_t i = 0; i < pictures; ++i) {
        std::vector<std::uint8_t> bytes(points, static_cast<std::uint8_t>(30 + 2 * i));
        bytes.resize(points * 3 / 2, 128);
        GstBuffer* buffer = gst_buffer_new_memdup(bytes.data(), bytes.size());
        GST_BUFFER_PTS(buffer) = i * 40 * GST_MSECOND;
        GST_BUFFER_DURATION(buffer) = 40 * GST_MSECOND;
        gst_app_src_push_buffer(GST_APP_SRC(source.get()), buffer);  // takes it
    }
    gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> end(gst_bus_timed_pop_filtered(
        bus.get(), 60 * GST_SECOND, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    REQUIRE(end);
    REQUIRE(GST_MESSAGE_TYPE(end.get()) == GST_MESSAGE_EOS);
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    return path.string();
}

}  // namespace

TEST_CASE("the small film shows each picture at its time in the film") {
    const TemporaryDirectory folder;
    const std::string film = grey_film(folder.path / "film.mkv", 1280, 96);
    const MediaInfo info = FilmSource(film, 320).info();
    const SmallFilmSize size = write_small_film(film, info, 3s, folder.path / "film.mp4");
    CHECK(size.width == 640);
    CHECK(size.height == 48);

    FilmSource read((folder.path / "film.mp4").string(), 640);
    CHECK(read.info().width == 640);
    CHECK(read.info().height == 48);
    CHECK(std::abs(std::chrono::duration<double>(read.info().duration - 3s).count()) <= 0.05);
    double before = 0;
    std::size_t number = 0;
    for (; const std::optional<FilmFrame> frame = read.next(); ++number) {
        CHECK(std::abs(std::chrono::duration<double>(frame->time - number * 40ms).count()) <= 0.005);
        const double grey = cv::mean(frame->picture)[0];
        CHECK(grey > before);
        before = grey;
    }
    CHECK(number == pictures);
}

TEST_CASE("a machine without the encoder says which one is missing") {
    start_gstreamer();
    CHECK_NOTHROW(require_film_encoder());
    GstRegistry* registry = gst_registry_get();
    GstPluginFeature* encoder = gst_registry_lookup_feature(registry, "x264enc");
    REQUIRE(encoder != nullptr);
    gst_registry_remove_feature(registry, encoder);
    CHECK_THROWS_WITH(require_film_encoder(), doctest::Contains("x264enc"));
    gst_registry_add_feature(registry, encoder);
    gst_object_unref(encoder);
}

TEST_CASE("a folder that cannot be written is named") {
    const TemporaryDirectory folder;
    const std::string film = grey_film(folder.path / "film.mkv", 64, 48);
    const MediaInfo info = FilmSource(film, 320).info();
    CHECK_THROWS_WITH(write_small_film(film, info, 3s, folder.path / "gone/film.mp4"),
                      doctest::Contains("gone/film.mp4"));
}

}  // namespace vitrine::analyzer
