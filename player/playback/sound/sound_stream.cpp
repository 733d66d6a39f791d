#include "player/playback/sound/sound_stream.hpp"

#include <utility>

namespace vitrine::player {

void SoundStream::connect(GstPad* pad, bool is_stamped) {
    is_stamped_ = is_stamped;
    constexpr auto events =
        static_cast<GstPadProbeType>(GST_PAD_PROBE_TYPE_EVENT_DOWNSTREAM | GST_PAD_PROBE_TYPE_EVENT_FLUSH);
    gst_pad_add_probe(pad, events, &SoundStream::on_event, this, nullptr);
    gst_pad_add_probe(pad, GST_PAD_PROBE_TYPE_BUFFER, &SoundStream::on_buffer, this, nullptr);
}

/// Places each loop: its place in running time is the shot's own time.
GstPadProbeReturn SoundStream::on_event(GstPad*, GstPadProbeInfo* info, gpointer self) {
    GstEvent* event = gst_pad_probe_info_get_event(info);
    auto* const stream = static_cast<SoundStream*>(self);
    if (GST_EVENT_TYPE(event) == GST_EVENT_FLUSH_STOP) stream->fade_.come();
    if (GST_EVENT_TYPE(event) != GST_EVENT_SEGMENT) return GST_PAD_PROBE_OK;
    info->data = stream->timeline_.placed(event, stream->is_stamped_).release();
    gst_event_unref(event);
    return GST_PAD_PROBE_OK;
}

GstPadProbeReturn SoundStream::on_buffer(GstPad* pad, GstPadProbeInfo* info, gpointer self) {
    auto* const stream = static_cast<SoundStream*>(self);
    const GstPtr<GstCaps> caps(gst_pad_get_current_caps(pad));
    int rate = 0;
    int channels = 0;
    const GstStructure* words = caps ? gst_caps_get_structure(caps.get(), 0) : nullptr;
    if (!words || !gst_structure_get_int(words, "rate", &rate) ||
        !gst_structure_get_int(words, "channels", &channels) || rate <= 0 || channels <= 0)
        return GST_PAD_PROBE_OK;
    info->data = gst_buffer_make_writable(gst_pad_probe_info_get_buffer(info));
    stream->fade_.apply(gst_pad_probe_info_get_buffer(info), rate, channels);
    stream->has_sounded_ = stream->is_heard_ = true;
    if (stream->fade_.is_silent() && !std::exchange(stream->is_silent_, true))
        stream->control_.post(silent_word);
    return GST_PAD_PROBE_OK;
}

}  // namespace vitrine::player
