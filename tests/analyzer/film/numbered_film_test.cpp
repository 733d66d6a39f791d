// The times of shots are the film's own: a shot begins with the very frame that the player seeks to.

#include "analyzer/film/frame_reader.hpp"
#include "base/media/gst_ptr.hpp"
#include "tests/analyzer/film/drawn_scenes.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gst/app/gstappsrc.h>

#include <map>

using namespace vitrine;
using namespace vitrine::analyzer;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

namespace {

constexpr int bits = 8;
constexpr int bit_side = 8;  // px

// The frame's number in light and dark squares along its lower edge.
cv::Mat numbered(const cv::Mat& picture, int number) {
    cv::Mat out = picture.clone();
    for (int bit = 0; bit < bits; ++bit)
        out(cv::Rect(bit * bit_side, out.rows - bit_side, bit_side, bit_side))
            .setTo(cv::Scalar::all((number >> bit & 1) != 0 ? 150 : 106));
    return out;
}

int number_of(const cv::Mat& picture) {
    int number = 0;
    for (int bit = 0; bit < bits; ++bit)
        if (picture.at<cv::Vec3b>(picture.rows - bit_side / 2, bit * bit_side + bit_side / 2)[1] > 128)
            number |= 1 << bit;
    return number;
}

// Frames of 20 to 60 ms.
milliseconds shown_at(int frame) {
    constexpr std::array lengths{milliseconds{20}, milliseconds{60}, milliseconds{40}, milliseconds{33}};
    milliseconds time{0};
    for (int i = 0; i < frame; ++i)
        time += lengths[static_cast<std::size_t>(i / 7) % lengths.size()];
    return time;
}

void write_film(const std::string& path, int frames, const Drawing& draw) {
    start_gstreamer();
    const GstPtr<GstElement> pipeline(gst_parse_launch(
        fmt::format(
            "appsrc name=source format=time caps=video/x-raw,format=BGR,width={},height={},framerate=0/1 ! "
            "videoconvert ! x264enc bframes=2 key-int-max=40 bitrate=4000 ! matroskamux ! filesink "
            "location={}",
            scene_size.width, scene_size.height, path)
            .c_str(),
        nullptr));
    REQUIRE(pipeline);
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "source"));
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    for (int i = 0; i < frames; ++i) {
        const cv::Mat picture = numbered(draw(i), i);
        const gsize size = picture.total() * picture.elemSize();
        GstBuffer* buffer = gst_buffer_new_memdup(picture.data, size);
        GST_BUFFER_PTS(buffer) = static_cast<GstClockTime>(nanoseconds(shown_at(i)).count());
        GST_BUFFER_DURATION(buffer) =
            static_cast<GstClockTime>(nanoseconds(shown_at(i + 1) - shown_at(i)).count());
        REQUIRE(gst_app_src_push_buffer(GST_APP_SRC(source.get()), buffer) ==
                GST_FLOW_OK);  // takes the buffer
    }
    gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> end(gst_bus_timed_pop_filtered(
        bus.get(), GST_CLOCK_TIME_NONE, static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS)));
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    REQUIRE(GST_MESSAGE_TYPE(end.get()) == GST_MESSAGE_EOS);
}

}  // namespace

TEST_CASE("a shot begins at the time of its first frame, in a film of varying rate") {
    const TemporaryDirectory folder;
    const std::string path = folder.path / "film.mkv";
    const cv::Mat third = scene(3, {20, 130, 60});
    const auto share_at = [](int i) {  // even in time
        return std::clamp(std::chrono::duration<double>(shown_at(i) - shown_at(119)) /
                              (shown_at(134) - shown_at(119)),
                          0.0, 1.0);
    };
    write_film(path, 180, [&](int i) { return i < 61 ? warm() : mixed(cold(), third, share_at(i)); });

    const auto film = open_media(path);
    ShotDetector detector;
    std::map<nanoseconds, int> numbers;
    std::vector<DetectedShot> shots;
    while (const auto frame = film->next()) {
        numbers[frame->time] = number_of(frame->picture);
        std::ranges::copy(detector.push(*frame), std::back_inserter(shots));
    }
    std::ranges::copy(detector.finish(film->info().duration), std::back_inserter(shots));

    REQUIRE(numbers.size() == 180);
    for (const auto& [time, number] : numbers)
        CHECK(std::chrono::abs(time - shown_at(number)) <= milliseconds(1));  // the container counts ms
    REQUIRE(shots.size() == 3);
    for (const DetectedShot& one : shots)
        CHECK(numbers.contains(one.begin));
    CHECK(numbers[shots[0].begin] == 0);
    CHECK(numbers[shots[0].end] == 61);
    CHECK(numbers[shots[1].begin] == 61);
    CHECK(numbers[shots[1].end] <= 122);  // an eighth of the dissolve still shows the shot's own picture
    CHECK(numbers[shots[2].begin] >= 132);
    CHECK(numbers[shots[2].begin] <= 141);
}
