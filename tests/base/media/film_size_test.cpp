#include "base/media/decode_chain.hpp"
#include "base/media/film_size.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gst/app/gstappsrc.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sys/resource.h>
#include <vector>

using namespace vitrine;

namespace {

using CodedPicture = std::vector<std::uint8_t>;

/// Runs a pipeline to its end. @param pictures  what its appsrc "pictures" gives, 25 a second
void run_to_end(const std::string& description, const std::vector<CodedPicture>& pictures = {}) {
    start_gstreamer();
    const GstPtr<GstElement> pipeline(gst_parse_launch(description.c_str(), nullptr));
    REQUIRE(pipeline);
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "pictures"));
    GstClockTime time = 0;
    for (const CodedPicture& picture : pictures) {
        GstBuffer* buffer = gst_buffer_new_memdup(picture.data(), picture.size());
        GST_BUFFER_PTS(buffer) = GST_BUFFER_DTS(buffer) = time;
        GST_BUFFER_DURATION(buffer) = 40 * GST_MSECOND;
        time += 40 * GST_MSECOND;
        gst_app_src_push_buffer(GST_APP_SRC(source.get()), buffer);  // takes the buffer
    }
    if (source) gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> end(gst_bus_timed_pop_filtered(
        bus.get(), 60 * GST_SECOND, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    REQUIRE(end);
    REQUIRE(GST_MESSAGE_TYPE(end.get()) == GST_MESSAGE_EOS);
}

/// A coded key picture of 96 x 64 px.
CodedPicture coded_picture(const TemporaryDirectory& folder, const std::string& encoder) {
    const std::string file = (folder.path / "picture").string();
    run_to_end(fmt::format(
        "videotestsrc num-buffers=1 ! video/x-raw,format=I420,width=96,height=64,framerate=25/1 ! {} ! "
        "filesink location={}",
        encoder, file));
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The JPEG with another size in its header.
CodedPicture jpeg_that_says(CodedPicture picture, unsigned width, unsigned height) {
    const CodedPicture mark{0xff, 0xc0};
    const auto frame = std::search(picture.begin(), picture.end(), mark.begin(), mark.end());
    REQUIRE(picture.end() - frame > 9);
    const auto set = [&](int at, unsigned side) {
        frame[at] = static_cast<std::uint8_t>(side >> 8U);
        frame[at + 1] = static_cast<std::uint8_t>(side);
    };
    set(5, height);
    set(7, width);
    return picture;
}

CodedPicture vp8_that_says(CodedPicture picture, unsigned width, unsigned height) {
    const auto set = [&](std::size_t at, unsigned side) {
        picture.at(at) = static_cast<std::uint8_t>(side);
        picture.at(at + 1) = static_cast<std::uint8_t>(side >> 8U);
    };
    set(6, width);
    set(8, height);
    return picture;
}

/// Writes a film of ten pictures, of which the sixth is another one. @return its path
std::string film_with(const TemporaryDirectory& folder, const std::string& caps_and_muxer,
                      const CodedPicture& picture, const CodedPicture& sixth) {
    std::vector<CodedPicture> pictures(10, picture);
    pictures[5] = sixth;
    const std::string path = (folder.path / "film").string();
    run_to_end(
        fmt::format("appsrc name=pictures format=time caps={} ! filesink location={}", caps_and_muxer, path),
        pictures);
    return path;
}

/// Decodes the film to its end. @return why it ended too soon; empty: it did not
std::string failure_of(const std::string& path) {
    DecodeChain chain(path,
                      make_bin("videoconvert ! video/x-raw,format=I420 ! appsink name=sink sync=false"));
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(chain.tail()), "sink"));
    try {
        chain.preroll();
        gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);
        while (chain.pull(GST_APP_SINK(sink.get()))) {
        }
    } catch (const MediaError& error) {
        CHECK(error.state() == MediaState::unsupported);
        return error.what();
    }
    return {};
}

/// The most memory that this process has had so far, MiB.
long peak_memory() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return use.ru_maxrss / 1024;
}

constexpr long picture_memory = 150;  // MiB; one of the large pictures takes 384 and more
constexpr const char* avi = "image/jpeg,width=96,height=64,framerate=25/1 ! m.video_0 avimux name=m";
constexpr const char* webm = "video/x-vp8,width=96,height=64,framerate=25/1 ! matroskamux";

}  // namespace

TEST_CASE("a film that becomes too large in its midst fails before that picture is decoded: MJPEG") {
    const TemporaryDirectory folder;
    const CodedPicture picture = coded_picture(folder, "jpegenc");
    const std::string path = film_with(folder, avi, picture, jpeg_that_says(picture, 16'000, 16'000));
    const long before = peak_memory();

    const std::string failure = failure_of(path);

    CHECK(failure ==
          "the film is too large: 16000 x 16000 px; up to 40 megapixels and 16384 px a side are shown");
    CHECK(peak_memory() - before < picture_memory);
}

TEST_CASE("a film that becomes too large in its midst fails before that picture is decoded: VP8") {
    const TemporaryDirectory folder;
    const CodedPicture picture = coded_picture(folder, "vp8enc");
    const std::string path = film_with(folder, webm, picture, vp8_that_says(picture, 16'383, 16'382));
    const long before = peak_memory();

    const std::string failure = failure_of(path);

    CHECK(failure ==
          "the film is too large: 16383 x 16382 px; up to 40 megapixels and 16384 px a side are shown");
    CHECK(peak_memory() - before < picture_memory);
}

TEST_CASE("a film that changes its size within the limits goes on") {
    const TemporaryDirectory folder;
    const CodedPicture picture = coded_picture(folder, "jpegenc");
    const std::string path = film_with(folder, avi, picture, jpeg_that_says(picture, 128, 96));
    CHECK(failure_of(path).empty());
}

TEST_CASE("a film whose pictures are too long on one side fails at its first one") {
    const TemporaryDirectory folder;
    const std::string path = (folder.path / "film").string();
    run_to_end(fmt::format(
        "videotestsrc num-buffers=3 ! video/x-raw,format=I420,width={},height=16,framerate=25/1 ! "
        "avenc_ffv1 ! matroskamux ! filesink location={}",
        max_film_side + 16, path));
    CHECK(failure_of(path) ==
          "the film is too large: 16400 x 16 px; up to 40 megapixels and 16384 px a side are shown");
}
