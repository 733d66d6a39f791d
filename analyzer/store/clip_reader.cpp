#include "analyzer/store/clip_reader.hpp"

#include <fmt/format.h>

namespace vitrine::analyzer {

namespace {

constexpr int frames_ahead = 4;  // decoded while earlier ones are coded

GstPtr<GstElement> tail_for(const ClipForm& form, bool is_toned) {
    start_gstreamer();
    return make_bin(
        fmt::format("videoconvertscale add-borders=false ! videoflip video-direction={}"
                    " ! video/x-raw,format={},width={},height={},pixel-aspect-ratio=1/1"
                    " ! appsink name=pictures sync=false qos=false max-buffers={} enable-last-sample=false",
                    static_cast<int>(form.turn), is_toned ? "RGBA" : "I420", form.width, form.height,
                    frames_ahead)
            .c_str());
}

}  // namespace

ClipReader::ClipReader(const std::string& film, const ClipForm& form)
    : tones_(ToneMap::of(form.colours)),
      chain_(film, tail_for(form, tones_.has_value())),
      sink_(gst_bin_get_by_name(GST_BIN(chain_.tail()), "pictures")) {
    chain_.preroll();
    gst_element_set_state(chain_.pipeline(), GST_STATE_PLAYING);
}

/// The frame with the tones of a usual screen. It keeps the decoder's untouched: others may refer to it.
GstPtr<GstSample> ClipReader::toned(GstPtr<GstSample> sample) const {
    sample.reset(gst_sample_make_writable(sample.release()));
    GstBuffer* buffer = gst_buffer_copy_deep(gst_sample_get_buffer(sample.get()));
    GstMapInfo bytes;
    if (gst_buffer_map(buffer, &bytes, GST_MAP_READWRITE)) {
        constexpr int channels = 4;
        tones_->apply({bytes.data, bytes.size}, channels, false);
        gst_buffer_unmap(buffer, &bytes);
    }
    gst_sample_set_buffer(sample.get(), buffer);
    gst_buffer_unref(buffer);
    return sample;
}

std::optional<ClipFrame> ClipReader::next() {
    while (GstPtr<GstSample> sample = chain_.pull(GST_APP_SINK(sink_.get()))) {
        const std::chrono::nanoseconds time = times_.of(sample.get());
        if (time <= last_) continue;  // each moment once, as in the analysis
        last_ = time;
        return ClipFrame{.sample = tones_ ? toned(std::move(sample)) : std::move(sample), .time = time};
    }
    return std::nullopt;
}

}  // namespace vitrine::analyzer
