// Films of plain pictures whose grey tells which picture it is.

#include "analyzer/store/film_clips.hpp"

#include "analyzer/store/clip_reader.hpp"
#include "tests/temporary_directory.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsrc.h>

#include <cstdlib>
#include <limits>
#include <vector>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t pictures = 75;
constexpr std::chrono::nanoseconds period = 40ms;

int grey_of(std::int64_t picture) {
    return static_cast<int>(30 + 2 * picture);
}

/// 64 x 48 px, 25 a second.
std::string write_film(const fs::path& path) {
    start_gstreamer();
    const std::string words = fmt::format(
        "appsrc name=in format=time caps=video/x-raw,format=I420,width=64,height=48,framerate=25/1"
        " ! avenc_ffv1 ! matroskamux ! filesink location={}",
        path.string());
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "in"));
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    for (std::size_t i = 0; i < pictures; ++i) {
        std::vector<std::uint8_t> bytes(64 * 48, static_cast<std::uint8_t>(grey_of(static_cast<int>(i))));
        bytes.resize(64 * 48 * 3 / 2, 128);
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

struct Film {
    std::vector<Shot> made(const std::vector<Shot>& shots) const {
        FilmClips clips(path, form, place);
        for (const Shot& shot : shots)
            clips.request_clip(shot);
        clips.finish();
        return clips.take_made();
    }

    fs::path file(const Shot& shot) const { return place.store / shot.stored->file; }

    TemporaryDirectory home;
    std::string path = write_film(home.path / "film.mkv");
    ClipForm form{.width = 64, .height = 48};
    StorePlace place{
        .store = home.path / "store", .id = std::string(16, 'a'), .clip_side = 64, .max_bytes = 1U << 20};
};

struct Seen {
    std::chrono::nanoseconds time{0};
    int grey = 0;
};

std::vector<Seen> seen_in(const fs::path& clip, const ClipForm& form) {
    ClipReader reader(clip.string(), form);
    std::vector<Seen> frames;
    while (const std::optional<ClipFrame> frame = reader.next()) {
        GstMapInfo map;
        REQUIRE(gst_buffer_map(gst_sample_get_buffer(frame->sample.get()), &map, GST_MAP_READ));
        frames.push_back({.time = frame->time, .grey = map.data[64 * 24 + 32]});
        gst_buffer_unmap(gst_sample_get_buffer(frame->sample.get()), &map);
    }
    return frames;
}

struct Unit {
    std::chrono::nanoseconds shown{0};
    std::chrono::nanoseconds decoded{0};
    bool is_key = false;
};

/// The coded pictures of an MP4 in the order they lie there.
std::vector<Unit> units_of(const fs::path& clip) {
    const std::string words =
        fmt::format("filesrc location={} ! qtdemux ! h264parse ! appsink name=out sync=false", clip.string());
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(pipeline.get()), "out"));
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    std::vector<Unit> units;
    while (const GstPtr<GstSample> sample{
        gst_app_sink_try_pull_sample(GST_APP_SINK(sink.get()), 10 * GST_SECOND)}) {
        const GstBuffer* buffer = gst_sample_get_buffer(sample.get());
        units.push_back({.shown = std::chrono::nanoseconds(GST_BUFFER_PTS(buffer)),
                         .decoded = std::chrono::nanoseconds(GST_BUFFER_DTS(buffer)),
                         .is_key = !GST_BUFFER_FLAG_IS_SET(buffer, GST_BUFFER_FLAG_DELTA_UNIT)});
    }
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    return units;
}

}  // namespace

TEST_CASE("each clip has its shot's pictures and no others, from time 0") {
    const Film film;
    const std::vector<Shot> shots{{.begin = 0s, .end = 480ms}, {.begin = 1s, .end = 3s}};
    const std::vector<Shot> made = film.made(shots);
    REQUIRE(made.size() == 2);
    for (const Shot& shot : made) {
        CHECK(shot.stored->begin == 0s);
        CHECK_FALSE(shot.stored->is_dropped);
        const std::vector<Seen> seen = seen_in(film.file(shot), film.form);
        REQUIRE(static_cast<std::int64_t>(seen.size()) == shot.duration() / period);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const auto picture = static_cast<std::int64_t>(i);
            CAPTURE(picture);
            CHECK(std::chrono::abs(seen[i].time - period * picture) < 100us);
            CHECK(std::abs(seen[i].grey - grey_of(shot.begin / period + picture)) <= 1);
        }
    }
}

TEST_CASE("a clip begins with a key picture, has one a second, and none waits for a later one") {
    const Film film;
    const std::vector<Shot> made = film.made({{.begin = 0s, .end = 3s}});
    REQUIRE(made.size() == 1);
    const std::vector<Unit> units = units_of(film.file(made[0]));
    REQUIRE(units.size() == pictures);
    std::chrono::nanoseconds last_key{0};
    CHECK(units.front().is_key);
    for (const Unit& unit : units) {
        CHECK(unit.shown == unit.decoded);
        if (unit.is_key) last_key = unit.shown;
        CHECK(unit.shown - last_key < 1s);
    }
}

TEST_CASE("a full disk leaves no half clip, and a place where it is made the next time") {
    const Film film;
    const Shot shot{.begin = 0s, .end = 1s};
    const fs::path folder = film.place.store / film.place.id;
    fs::create_directories(folder);
    fs::create_symlink("/dev/full", folder / "0-1000000000-64.mp4.new");
    const std::vector<Shot> made = film.made({shot});
    REQUIRE(made.size() == 1);
    CHECK_FALSE(made[0].stored->is_dropped);
    CHECK(fs::is_empty(folder));
    CHECK(film.made({shot}).size() == 1);
    CHECK(fs::exists(film.file(made[0])));
}

TEST_CASE("a disk that must be kept free is not written to") {
    Film film;
    film.place.min_free_bytes = std::numeric_limits<std::uint64_t>::max();
    CHECK(film.made({{.begin = 0s, .end = 1s}}).size() == 1);
    CHECK(fs::is_empty(film.place.store / film.place.id));
}

TEST_CASE("a clip that is too large is given up, the next one is made") {
    Film film;
    film.place.max_bytes = 3000;
    const std::vector<Shot> made = film.made({{.begin = 0s, .end = 2s}, {.begin = 2s, .end = 2080ms}});
    REQUIRE(made.size() == 2);
    CHECK(made[0].stored->is_dropped);
    CHECK_FALSE(fs::exists(film.file(made[0])));
    CHECK_FALSE(made[1].stored->is_dropped);
    CHECK(fs::exists(film.file(made[1])));
}

TEST_CASE("a film that breaks off has the clips before") {
    const Film film;
    fs::resize_file(film.path, fs::file_size(film.path) / 2);
    const std::vector<Shot> made = film.made({{.begin = 0s, .end = 200ms}, {.begin = 200ms, .end = 3s}});
    REQUIRE_FALSE(made.empty());
    CHECK(fs::exists(film.file(made[0])));
}

TEST_CASE("what is not made yet is given up at once") {
    const Film film;
    FilmClips clips(film.path, film.form, film.place);
    clips.request_clip({.begin = 0s, .end = 3s});
}
