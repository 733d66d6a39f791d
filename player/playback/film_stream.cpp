#include "player/playback/film_stream.hpp"

#include "base/media/film_elements.hpp"
#include "player/playback/shared_frame.hpp"

#include <time.h>

#include <exception>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::chrono::nanoseconds rounding = std::chrono::milliseconds(1);  // Matroska rounds times to this

/// Processor time of the calling thread.
std::chrono::nanoseconds thread_time() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

FilmStream::FilmStream(const FilmPart& part, SampleQueue& queue, PictureForm form)
    : part_(part), queue_(queue), size_(Size{part.width, part.height}), scaler_(form) {}

void FilmStream::connect(GstElement* sink) {
    GstAppSinkCallbacks callbacks{};
    callbacks.new_sample = &FilmStream::on_sample;
    gst_app_sink_set_callbacks(GST_APP_SINK(sink), &callbacks, this, nullptr);
    const GstPtr<GstPad> pad(gst_element_get_static_pad(sink, "sink"));
    gst_pad_add_probe(pad.get(), GST_PAD_PROBE_TYPE_EVENT_FLUSH, &FilmStream::on_flush, this, nullptr);
    let_planes_lie(pad.get());
}

GstFlowReturn FilmStream::on_sample(GstAppSink* sink, gpointer self) {
    const GstPtr<GstSample> sample(gst_app_sink_pull_sample(sink));
    if (!sample) return GST_FLOW_EOS;
    try {
        return static_cast<FilmStream*>(self)->put(sample.get());
    } catch (const std::exception& error) {  // no memory
        post_error(GST_ELEMENT(sink), GST_STREAM_ERROR_FAILED, error.what(), "vitrine-no-picture");
        return GST_FLOW_ERROR;
    }
}

/// After a flush the streaming thread stands still and its pictures are dropped: the next picture is from the
/// new place.
GstPadProbeReturn FilmStream::on_flush(GstPad*, GstPadProbeInfo* info, gpointer self) {
    if (GST_EVENT_TYPE(gst_pad_probe_info_get_event(info)) != GST_EVENT_FLUSH_STOP) return GST_PAD_PROBE_OK;
    auto* const stream = static_cast<FilmStream*>(self);
    const std::optional<std::chrono::nanoseconds> at = std::exchange(stream->landing_, std::nullopt);
    if (!at) return GST_PAD_PROBE_OK;
    const std::chrono::nanoseconds duration = stream->part_.duration();
    stream->loop_ = static_cast<std::uint64_t>(*at / duration);
    stream->last_ = stream->part_.begin + *at % duration - stream->window_.period;
    stream->queue_.refuse(false);
    return GST_PAD_PROBE_OK;
}

/// @throws std::bad_alloc
GstFlowReturn FilmStream::put(GstSample* sample) {
    const std::optional<std::chrono::nanoseconds> time = time_in_film(sample);
    if (!time) return GST_FLOW_OK;  // outside the segment
    std::chrono::nanoseconds stream_time = *time;
    const bool is_before = stream_time < part_.begin - window_.period / 2;
    if (is_before || (window_.end && stream_time >= *window_.end)) return GST_FLOW_OK;
    if (stream_time <= window_.begin + rounding) stream_time = part_.begin;  // the segment cut its start off
    const Size size = size_;
    std::optional<Sample> picture = scaler_.scaled(sample, size.width, size.height, stream_time);
    if (!picture) return GST_FLOW_OK;
    if (last_ && stream_time <= *last_) ++loop_;
    last_ = stream_time;
    note_cost();
    const bool is_open =
        queue_.put({.sample = std::move(*picture), .loop = loop_, .duration = window_.period});
    ++pictures_;
    return is_open ? GST_FLOW_OK : GST_FLOW_EOS;
}

std::optional<std::chrono::nanoseconds> FilmStream::time_in_film(GstSample* sample) const {
    const std::uint64_t time = GST_BUFFER_PTS(gst_sample_get_buffer(sample));
    if (window_.is_named_by_stamp && GST_CLOCK_TIME_IS_VALID(time)) return std::chrono::nanoseconds(time);
    const std::uint64_t stream_time =
        gst_segment_to_stream_time(gst_sample_get_segment(sample), GST_FORMAT_TIME, time);
    if (!GST_CLOCK_TIME_IS_VALID(stream_time)) return std::nullopt;
    return std::chrono::nanoseconds(stream_time);
}

/// The thread is checked each time: another thread may stream after a seek.
void FilmStream::note_cost() {
    const std::chrono::nanoseconds now = thread_time();
    if (noted_thread_ == std::this_thread::get_id()) spent_ = spent_.load() + now - noted_;
    noted_thread_ = std::this_thread::get_id();
    noted_ = now;
}

}  // namespace vitrine::player
