#include "analyzer/store/clip_writer.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsrc.h>
#include <gst/video/video.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace {

namespace fs = std::filesystem;
using std::chrono::nanoseconds;
using Why = ClipError::Why;

constexpr nanoseconds usual_duration{40'000'000};  // the duration of the last frame, if it is not known
constexpr std::uint64_t frames_ahead = 4;          // handed over and not coded yet
constexpr GstClockTime patience = 60 * GST_SECOND;
constexpr GstClockTime room_patience = 2 * GST_MSECOND;  // between two checks
constexpr int look_interval = 32;                        // frames between two checks of the size
constexpr int max_rate = 120;                            // a higher one is a container's unit of time
constexpr double bits_a_pixel = 0.4;                     // at most, at 30 frames a second

/// Frames a second; 0 where the film does not say, or says nonsense.
int rate_of(GstSample* like) {
    GstVideoInfo info;
    if (!gst_video_info_from_caps(&info, gst_sample_get_caps(like)) || info.fps_d <= 0) return 0;
    const int rate = (info.fps_n + info.fps_d - 1) / info.fps_d;
    return rate > max_rate ? 0 : rate;
}

/// The format of the frames for the encoder.
GstPtr<GstCaps> caps_of(GstSample* like) {
    GstPtr<GstCaps> caps(gst_caps_copy(gst_sample_get_caps(like)));
    if (rate_of(like) == 0) gst_caps_set_simple(caps.get(), "framerate", GST_TYPE_FRACTION, 0, 1, nullptr);
    return caps;
}

std::string words_for(GstSample* like) {
    GstVideoInfo info;
    if (!gst_video_info_from_caps(&info, gst_sample_get_caps(like)))
        throw ClipError(Why::broken, "frames of unknown layout");
    constexpr int usual_rate = 15;  // shorter intervals do no harm where the true rate is higher
    const int rate = rate_of(like) == 0 ? usual_rate : std::max(1, rate_of(like));
    const double kilobits = bits_a_pixel * 30 * info.width * info.height / 1000;
    const bool is_toned = GST_VIDEO_INFO_IS_RGB(&info);
    return fmt::format(
        "appsrc name=frames format=time max-buffers=0 max-bytes=0"
        " ! videoconvert ! video/x-raw,format=I420{}"
        " ! x264enc speed-preset=superfast tune=fastdecode+zerolatency threads=1 bframes=0 key-int-max={}"
        " pass=qual quantizer=22 bitrate={:.0f} vbv-buf-capacity=2000"
        " ! video/x-h264,stream-format=avc ! h264parse ! mp4mux ! filesink name=file",
        is_toned ? ",colorimetry=bt709" : "", rate, std::max(500.0, kilobits));
}

ClipError failure(GstMessage* message) {
    GError* raw = nullptr;
    gst_message_parse_error(message, &raw, nullptr);
    const GstPtr<GError> error(raw);
    const bool is_full = g_error_matches(raw, GST_RESOURCE_ERROR, GST_RESOURCE_ERROR_NO_SPACE_LEFT);
    return {is_full ? Why::no_room : Why::broken, error->message};
}

}  // namespace

bool ClipWriter::has_encoder() {
    start_gstreamer();
    GstElementFactory* factory = gst_element_factory_find("x264enc");
    if (factory != nullptr) gst_object_unref(factory);
    return factory != nullptr;
}

ClipWriter::ClipWriter(fs::path file, GstSample* like, std::uint64_t max_bytes)
    : file_(std::move(file)), max_bytes_(max_bytes) {
    start_gstreamer();
    GError* raw = nullptr;
    pipeline_.reset(gst_parse_launch(words_for(like).c_str(), &raw));
    const GstPtr<GError> error(raw);
    if (!pipeline_ || error) throw ClipError(Why::broken, error ? error->message : "no encoder");
    gst_object_ref_sink(pipeline_.get());
    bus_.reset(gst_element_get_bus(pipeline_.get()));
    source_.reset(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "frames"));
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(pipeline_.get()), "file"));
    g_object_set(sink.get(), "location", unfinished(file_).c_str(), nullptr);
    gst_app_src_set_caps(GST_APP_SRC(source_.get()), caps_of(like).get());
    gst_element_set_state(pipeline_.get(), GST_STATE_PLAYING);  // a failure comes as a message
}

ClipWriter::~ClipWriter() {
    if (!pipeline_) return;
    gst_element_set_state(pipeline_.get(), GST_STATE_NULL);
    std::error_code ignored;  // it may never have been made
    fs::remove(unfinished(file_), ignored);
}

void ClipWriter::push(GstSample* frame, nanoseconds time) {
    if (held_) send(time);
    held_.reset(gst_sample_ref(frame));
    held_time_ = time;
    if (++frames_ % look_interval == 0 && size() > max_bytes_)
        throw ClipError(Why::too_large, "the clip is too large");
}

/// Hands over the frame that is held; waits while the encoder is behind.
void ClipWriter::send(nanoseconds until) {
    GstBuffer* buffer = gst_buffer_copy(gst_sample_get_buffer(held_.get()));  // its data are shared
    GST_BUFFER_PTS(buffer) = static_cast<GstClockTime>(held_time_.count());
    GST_BUFFER_DTS(buffer) = GST_CLOCK_TIME_NONE;
    GST_BUFFER_DURATION(buffer) =
        static_cast<GstClockTime>(std::max(nanoseconds(1), until - held_time_).count());
    held_.reset();
    wait_for_room();
    if (gst_app_src_push_buffer(GST_APP_SRC(source_.get()), buffer) != GST_FLOW_OK)  // it takes the buffer
        throw ClipError(Why::broken, "the encoder refuses a frame");
}

/// A source that blocks would do so for ever where the encoder has failed.
void ClipWriter::wait_for_room() {
    for (GstClockTime waited = 0; waited < patience; waited += room_patience) {
        const bool has_room =
            gst_app_src_get_current_level_buffers(GST_APP_SRC(source_.get())) < frames_ahead;
        const GstPtr<GstMessage> message(
            gst_bus_timed_pop_filtered(bus_.get(), has_room ? 0 : room_patience, GST_MESSAGE_ERROR));
        if (message) throw failure(message.get());
        if (has_room) return;
    }
    throw ClipError(Why::broken, "the encoder is stuck");
}

void ClipWriter::finish(nanoseconds end) {
    if (!held_) throw ClipError(Why::broken, "a shot without a frame");
    send(end > held_time_ ? end : held_time_ + usual_duration);
    gst_app_src_end_of_stream(GST_APP_SRC(source_.get()));
    const GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(
        bus_.get(), patience, static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS)));
    if (!message) throw ClipError(Why::broken, "the encoder does not finish");
    if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_ERROR) throw failure(message.get());
    gst_element_set_state(pipeline_.get(), GST_STATE_NULL);
    if (size() > max_bytes_) throw ClipError(Why::too_large, "the clip is too large");
    try {
        publish_file(unfinished(file_), file_);
    } catch (const std::system_error& error) {
        throw ClipError(error.code() == std::errc::no_space_on_device ? Why::no_room : Why::broken,
                        error.what());
    }
}

std::uint64_t ClipWriter::size() const {
    std::error_code missing;
    const std::uintmax_t bytes = fs::file_size(unfinished(file_), missing);
    return missing ? 0 : bytes;
}

}  // namespace vitrine::analyzer
