#include "base/media/tone_probe.hpp"

#include "base/media/tone_map.hpp"

#include <memory>

namespace vitrine {

namespace {

// Shared by the two probes of one tail; both run in its streaming thread.
using Tones = std::shared_ptr<std::optional<ToneMap>>;  // shared: either probe may be freed first

GstPadProbeReturn note_colours(GstPad*, GstPadProbeInfo* info, gpointer tones) {
    GstEvent* event = gst_pad_probe_info_get_event(info);
    if (GST_EVENT_TYPE(event) != GST_EVENT_CAPS) return GST_PAD_PROBE_OK;
    GstCaps* caps = nullptr;  // lent by the event
    gst_event_parse_caps(event, &caps);
    GstVideoInfo video;
    if (gst_video_info_from_caps(&video, caps)) **static_cast<Tones*>(tones) = ToneMap::of(video.colorimetry);
    return GST_PAD_PROBE_OK;
}

GstPadProbeReturn tone_down(GstPad*, GstPadProbeInfo* info, gpointer tones) {
    const std::optional<ToneMap>& map = **static_cast<Tones*>(tones);
    if (!map) return GST_PAD_PROBE_OK;
    GstBuffer* buffer = gst_buffer_make_writable(gst_pad_probe_info_get_buffer(info));
    info->data = buffer;  // the writable one, whose owner it is
    GstMapInfo bytes;
    if (!gst_buffer_map(buffer, &bytes, GST_MAP_READWRITE)) return GST_PAD_PROBE_OK;
    constexpr int channels = 4;
    map->apply({bytes.data, bytes.size}, channels, false);
    gst_buffer_unmap(buffer, &bytes);
    return GST_PAD_PROBE_OK;
}

void probe(GstElement* element, GstPadProbeType type, GstPadProbeCallback call, const Tones& tones) {
    const GstPtr<GstPad> pad(gst_element_get_static_pad(element, "sink"));
    const auto free = [](gpointer owned) { delete static_cast<Tones*>(owned); };
    gst_pad_add_probe(pad.get(), type, call, std::make_unique<Tones>(tones).release(),
                      free);  // which owns it
}

}  // namespace

void map_tones(GstElement* tail, GstElement* sink) {
    const auto tones = std::make_shared<std::optional<ToneMap>>();
    probe(tail, GST_PAD_PROBE_TYPE_EVENT_DOWNSTREAM, note_colours, tones);
    probe(sink, GST_PAD_PROBE_TYPE_BUFFER, tone_down, tones);
}

}  // namespace vitrine
