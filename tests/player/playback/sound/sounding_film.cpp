#include "tests/player/playback/sound/sounding_film.hpp"

#include <fmt/format.h>
#include <gst/app/gstappsrc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <thread>

namespace vitrine::player {

namespace {

constexpr int rate = 44100;
constexpr int pictures_a_second = 10;
constexpr int lowest = 500;  // Hz, in the first second
constexpr int step = 250;    // Hz more in each further one
constexpr double min_loudness = 0.02;
constexpr std::chrono::nanoseconds patience = std::chrono::seconds(60);

GstBuffer* tone(int second) {
    constexpr std::size_t bytes = rate * sizeof(std::int16_t);
    GstBuffer* buffer = gst_buffer_new_allocate(nullptr, bytes, nullptr);
    GstMapInfo map;
    gst_buffer_map(buffer, &map, GST_MAP_WRITE);
    auto* samples = static_cast<std::int16_t*>(static_cast<void*>(map.data));
    for (int i = 0; i < rate; ++i)
        samples[i] = static_cast<std::int16_t>(
            12000 * std::sin(2 * std::numbers::pi * (lowest + step * second) * i / rate));
    gst_buffer_unmap(buffer, &map);
    GST_BUFFER_PTS(buffer) = static_cast<GstClockTime>(second) * GST_SECOND;
    GST_BUFFER_DURATION(buffer) = GST_SECOND;
    return buffer;
}

SoundRecorder::Piece piece_of(GstSample* sample) {
    SoundRecorder::Piece piece;
    int channels = 1;
    const GstStructure* words = gst_caps_get_structure(gst_sample_get_caps(sample), 0);
    gst_structure_get_int(words, "rate", &piece.rate);
    gst_structure_get_int(words, "channels", &channels);
    GstBuffer* buffer = gst_sample_get_buffer(sample);
    guint64 time = 0;
    const int sign = gst_segment_to_running_time_full(gst_sample_get_segment(sample), GST_FORMAT_TIME,
                                                      GST_BUFFER_PTS(buffer), &time);
    piece.time = std::chrono::nanoseconds(time) * sign;
    GstMapInfo map;
    gst_buffer_map(buffer, &map, GST_MAP_READ);
    const auto* samples = static_cast<const float*>(static_cast<const void*>(map.data));
    for (std::size_t i = 0; i < map.size / sizeof(float); i += static_cast<std::size_t>(channels))
        piece.samples.push_back(samples[i]);
    gst_buffer_unmap(buffer, &map);
    return piece;
}

}  // namespace

void write_sounding_film(const std::string& file, const SoundingFilm& film) {
    start_gstreamer();
    const std::string sound =
        film.encoder.empty()
            ? ""
            : fmt::format("appsrc name=sound format=time caps=audio/x-raw,format=S16LE,layout=interleaved,"
                          "rate={},channels=1 ! audioconvert ! audioresample ! {} ! queue ! muxer.",
                          rate, film.encoder);
    const std::string words =
        fmt::format("videotestsrc num-buffers={} ! video/x-raw,format=I420,width=64,height=48,framerate={}/1"
                    " ! {} ! queue ! {} name=muxer ! filesink name=file {}",
                    film.seconds * pictures_a_second, pictures_a_second, film.picture, film.muxer, sound);
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    if (!pipeline) throw std::runtime_error("cannot build " + words);
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(pipeline.get()), "file"));
    g_object_set(sink.get(), "location", file.c_str(), nullptr);
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    if (const GstPtr<GstElement> source{gst_bin_get_by_name(GST_BIN(pipeline.get()), "sound")}) {
        for (int i = 0; i < film.seconds; ++i)
            gst_app_src_push_buffer(GST_APP_SRC(source.get()), tone(i));  // takes the buffer
        gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    }
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> message(
        gst_bus_timed_pop_filtered(bus.get(), static_cast<GstClockTime>(patience.count()),
                                   static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    const bool is_written = message && GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS;
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    if (!is_written) throw std::runtime_error("cannot write " + words);
}

struct SoundRecorder::Made {
    std::mutex mutex;
    std::vector<GstPtr<GstElement>> sinks;  // guarded by mutex
};

SoundSink SoundRecorder::sink() {
    if (!made_) made_ = std::make_shared<Made>();
    return [made = made_] {
        GstPtr<GstElement> sink = make_element("appsink");
        g_object_set(sink.get(), "sync", FALSE, "max-buffers", 20U, "wait-on-eos", FALSE, nullptr);
        const GstPtr<GstCaps> caps(gst_caps_from_string("audio/x-raw,format=F32LE,layout=interleaved"));
        g_object_set(sink.get(), "caps", caps.get(), nullptr);
        const std::lock_guard lock(made->mutex);
        made->sinks.emplace_back(static_cast<GstElement*>(gst_object_ref(sink.get())));
        return sink;
    };
}

std::size_t SoundRecorder::sinks() const {
    const std::lock_guard lock(made_->mutex);
    return made_->sinks.size();
}

/// Lent by what was made.
GstAppSink* SoundRecorder::newest() const {
    const std::lock_guard lock(made_->mutex);
    return made_->sinks.empty() ? nullptr : GST_APP_SINK(made_->sinks.back().get());
}

// A sink that is not playing yet, or is being sent elsewhere, gives nothing at once.
std::vector<SoundRecorder::Piece> SoundRecorder::take(std::chrono::nanoseconds duration) {
    std::vector<Piece> pieces;
    const auto end = std::chrono::steady_clock::now() + patience;
    std::chrono::nanoseconds taken{0};
    while (taken < duration && std::chrono::steady_clock::now() < end) {
        GstAppSink* sink = newest();
        const GstPtr<GstSample> sample(sink ? gst_app_sink_try_pull_sample(sink, GST_SECOND) : nullptr);
        if (!sample) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            continue;
        }
        pieces.push_back(piece_of(sample.get()));
        taken += pieces.back().duration();
    }
    return pieces;
}

void SoundRecorder::throw_away() {
    GstAppSink* sink = newest();
    while (sink && GstPtr<GstSample>(gst_app_sink_try_pull_sample(sink, 0))) {
    }
}

int second_heard(const float* samples, std::size_t count, int rate_heard) {
    int crossings = 0;
    float loudest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        loudest = std::max(loudest, std::abs(samples[i]));
        if (i > 0 && (samples[i - 1] < 0) != (samples[i] < 0)) ++crossings;
    }
    if (loudest < min_loudness) return -1;
    const double frequency = crossings / 2.0 * rate_heard / static_cast<double>(count);
    return static_cast<int>(std::lround((frequency - lowest) / step));
}

}  // namespace vitrine::player
