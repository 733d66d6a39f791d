#include "player/playback/sound/sound_sink.hpp"

#include <cstdint>
#include <stdexcept>

namespace vitrine::player {

namespace {

// The fade comes after the queue, so that sound decoded ahead does not delay it. Conversion to the device's
// format comes after the fade.
constexpr const char* decoding_words =
    "audioconvert ! audioresample ! capsfilter caps=\"audio/x-raw,format=F32LE,layout=interleaved\""
    " ! queue name=ahead max-size-buffers=0 max-size-bytes=0 max-size-time=600000000"
    " ! identity name=fade ! audioconvert";
constexpr std::int64_t device_buffer = 100'000;  // microseconds: a fade is delayed by this

}  // namespace

SoundSink alsa_sink(const std::string& device) {
    return [device] {
        GstPtr<GstElement> sink = make_element("alsasink");
        g_object_set(sink.get(), "device", device.c_str(), "buffer-time", device_buffer, "provide-clock",
                     FALSE, nullptr);
        return sink;
    };
}

GstPtr<GstElement> sound_tail(GstElement* sink) {
    GstPtr<GstElement> tail(gst_bin_new(nullptr));
    gst_object_ref_sink(tail.get());
    const GstPtr<GstElement> decoding = make_bin(decoding_words);
    gst_bin_add(GST_BIN(tail.get()), decoding.get());
    gst_bin_add(GST_BIN(tail.get()), sink);
    if (!gst_element_link(decoding.get(), sink))
        throw std::runtime_error("the sound's sink cannot be linked");
    const GstPtr<GstPad> pad(gst_element_get_static_pad(decoding.get(), "sink"));
    gst_element_add_pad(tail.get(), gst_ghost_pad_new("sink", pad.get()));  // takes the pad
    return tail;
}

}  // namespace vitrine::player
