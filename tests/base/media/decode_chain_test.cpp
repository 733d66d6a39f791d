#include "base/media/decode_chain.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>
#include <vector>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

constexpr auto deadline = 60s;  // only ever reached by a failure

// A folder of its own that goes with the test.
struct TempFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("vitrine-chain-{}", ::getpid());

    TempFolder() { std::filesystem::create_directories(path); }

    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    ~TempFolder() { std::filesystem::remove_all(path); }
};

// Runs a pipeline description to its end: films are drawn by the test.
void run(const std::string& description) {
    start_gstreamer();
    GError* error = nullptr;
    GstElement* pipeline = gst_parse_launch(description.c_str(), &error);
    REQUIRE_MESSAGE(pipeline, (error ? error->message : ""));
    const GstPtr<GstElement> owned(pipeline);
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline));
    gst_element_set_state(pipeline, GST_STATE_PLAYING);
    const GstPtr<GstMessage> end(gst_bus_timed_pop_filtered(
        bus.get(), GST_CLOCK_TIME_NONE, static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS)));
    gst_element_set_state(pipeline, GST_STATE_NULL);
    REQUIRE(GST_MESSAGE_TYPE(end.get()) == GST_MESSAGE_EOS);
}

std::string drawn_film(const TempFolder& folder, const std::string& codec, const std::string& name) {
    const std::string path = folder.path / name;
    run(fmt::format("videotestsrc num-buffers=30 ! video/x-raw,width=96,height=64,framerate=25/1 ! {} ! "
                    "filesink location={}",
                    codec, path));
    return path;
}

GstAppSink* sink_of(const DecodeChain& chain) {
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(chain.tail()), "sink"));
    return GST_APP_SINK(sink.get());  // the chain holds it
}

std::vector<GstClockTime> stream_times(const DecodeChain& chain) {
    std::vector<GstClockTime> times;
    while (true) {
        const GstPtr<GstSample> sample(gst_app_sink_pull_sample(sink_of(chain)));
        if (!sample) return times;
        const GstSegment* segment = gst_sample_get_segment(sample.get());
        times.push_back(gst_segment_to_stream_time(segment, GST_FORMAT_TIME,
                                                   GST_BUFFER_PTS(gst_sample_get_buffer(sample.get()))));
    }
}

GstPtr<GstElement> frames_tail() {
    start_gstreamer();
    return make_bin("queue ! videoconvertscale ! video/x-raw,format=RGBA ! appsink name=sink sync=false");
}

}  // namespace

TEST_CASE("every frame of a film arrives at its stream time") {
    const TempFolder folder;
    const std::string path = drawn_film(folder, "x264enc bframes=2 key-int-max=10 ! mp4mux", "film.mp4");
    DecodeChain chain(path, frames_tail());
    chain.preroll();
    CHECK(chain.duration() == 1200ms);
    gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);

    const auto times = stream_times(chain);

    REQUIRE(times.size() == 30);
    for (std::size_t i = 0; i < times.size(); ++i)
        CHECK(times[i] == i * 40 * GST_MSECOND);
}

TEST_CASE("a segment seek gives the frames of the segment and says when it is done") {
    const TempFolder folder;
    const std::string path = drawn_film(folder, "x264enc key-int-max=10 ! mp4mux", "film.mp4");
    DecodeChain chain(path, frames_tail());
    chain.preroll();
    const auto flags =
        static_cast<GstSeekFlags>(GST_SEEK_FLAG_FLUSH | GST_SEEK_FLAG_SEGMENT | GST_SEEK_FLAG_ACCURATE);
    REQUIRE(gst_element_seek(chain.pipeline(), 1.0, GST_FORMAT_TIME, flags, GST_SEEK_TYPE_SET,
                             400 * GST_MSECOND, GST_SEEK_TYPE_SET, 600 * GST_MSECOND));
    gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);

    const GstPtr<GstMessage> done(gst_bus_timed_pop_filtered(
        chain.bus(), static_cast<GstClockTime>(std::chrono::nanoseconds(deadline).count()),
        static_cast<GstMessageType>(GST_MESSAGE_SEGMENT_DONE | GST_MESSAGE_ERROR)));

    REQUIRE(done);
    CHECK(GST_MESSAGE_TYPE(done.get()) == GST_MESSAGE_SEGMENT_DONE);
    for (int i = 0; i < 5; ++i) {
        const GstPtr<GstSample> sample(gst_app_sink_pull_sample(sink_of(chain)));
        CHECK(gst_segment_to_stream_time(gst_sample_get_segment(sample.get()), GST_FORMAT_TIME,
                                         GST_BUFFER_PTS(gst_sample_get_buffer(sample.get()))) ==
              (400 + static_cast<GstClockTime>(i) * 40) * GST_MSECOND);
    }
}

TEST_CASE("a file of sound only is refused in those words") {
    const TempFolder folder;
    const std::string path = folder.path / "sound.mkv";
    run(fmt::format("audiotestsrc num-buffers=20 ! vorbisenc ! matroskamux ! filesink location={}", path));
    DecodeChain chain(path, frames_tail());
    try {
        chain.preroll();
        FAIL("a film without pictures was accepted");
    } catch (const MediaError& error) {
        CHECK(error.state() == MediaState::unsupported);
        CHECK(std::string(error.what()) == "the file holds only sound");
    }
}

TEST_CASE("a film in a codec that no document names is refused, with a way out") {
    const TempFolder folder;
    const std::string path = drawn_film(folder, "avenc_huffyuv ! avimux", "film.avi");
    try {
        DecodeChain(path, make_bin("fakesink name=sink")).preroll();
        FAIL("no error");
    } catch (const MediaError& error) {
        CHECK(error.state() == MediaState::unsupported);
        CHECK(std::string(error.what()).ends_with("not decoded here; H.264 in MP4 plays everywhere"));
    }
}

TEST_CASE("what a library says of a film is not the operator's reason") {
    start_gstreamer();
    for (const int code : {GST_STREAM_ERROR_DEMUX, GST_STREAM_ERROR_DECODE, GST_STREAM_ERROR_FAILED,
                           GST_STREAM_ERROR_WRONG_TYPE, GST_STREAM_ERROR_CODEC_NOT_FOUND}) {
        const GstPtr<GError> said(
            g_error_new_literal(GST_STREAM_ERROR, code, "qtdemux0: /srv/media/a.mp4: Could not demultiplex"));
        const GstPtr<GstMessage> message(gst_message_new_error(nullptr, said.get(), nullptr));
        const std::string reason = media_error(message.get()).what();
        CAPTURE(reason);
        CHECK(reason.starts_with("the film"));
        CHECK(reason.find("srv") == std::string::npos);
        CHECK(reason.find("demu") == std::string::npos);
    }
}

TEST_CASE("a film may grow in its midst, but not so far that a small one takes the memory of a large one") {
    const TempFolder folder;
    const std::string small = drawn_film(folder, "x264enc ! mpegtsmux", "small.ts");
    // Plays the small film and then another size of it; returns the largest width of a picture, or why it
    // ended.
    const auto play = [&](int width, int height) -> std::string {
        const std::string both = folder.path / "both.ts";
        const std::string large = folder.path / "large.ts";
        run(fmt::format("videotestsrc num-buffers=10 ! video/x-raw,width={},height={},framerate=25/1 ! "
                        "x264enc speed-preset=ultrafast ! mpegtsmux ! filesink location={}",
                        width, height, large));
        std::filesystem::copy_file(small, both, std::filesystem::copy_options::overwrite_existing);
        std::ofstream(both, std::ios::app | std::ios::binary)
            << std::ifstream(large, std::ios::binary).rdbuf();
        int widest = 0;
        try {
            DecodeChain chain(both, frames_tail());
            chain.preroll();
            gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);
            while (const GstPtr<GstSample> sample = chain.pull(sink_of(chain))) {
                int found = 0;
                gst_structure_get_int(gst_caps_get_structure(gst_sample_get_caps(sample.get()), 0), "width",
                                      &found);
                widest = std::max(widest, found);
            }
        } catch (const MediaError& error) {
            CHECK(error.state() == MediaState::unsupported);
            return error.what();
        }
        return fmt::format("{}", widest);
    };
    CHECK(play(1280, 720) == "1280");
    CHECK(play(2048, 1088) == "a picture in its midst is far larger than its first: 2048 x 1088 px");
}
