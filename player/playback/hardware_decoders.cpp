#include "player/playback/hardware_decoders.hpp"

#include "base/media/gst_ptr.hpp"

#include <fmt/format.h>

#include <array>

namespace vitrine::player {

namespace {

struct Candidate {
    const char* software;
    const char* hardware;
};

// The best first. GStreamer's own ranks do not give this order: VA has none in 1.22.
constexpr std::array candidates{
    Candidate{"avdec_h264", "v4l2slh264dec"},
    Candidate{"avdec_h265", "v4l2slh265dec"},
    Candidate{"avdec_vp8", "v4l2slvp8dec"},
    Candidate{"avdec_vp9", "v4l2slvp9dec"},
    Candidate{"avdec_mpeg2video", "v4l2slmpeg2dec"},
    Candidate{"avdec_h264", "vah264dec"},
    Candidate{"avdec_h265", "vah265dec"},
    Candidate{"avdec_vp8", "vavp8dec"},
    Candidate{"avdec_vp9", "vavp9dec"},
    Candidate{"av1dec", "vaav1dec"},
    Candidate{"avdec_mpeg2video", "vampeg2dec"},
    Candidate{"avdec_h264", "v4l2h264dec"},
    Candidate{"avdec_h265", "v4l2h265dec"},
    Candidate{"avdec_vp8", "v4l2vp8dec"},
    Candidate{"avdec_vp9", "v4l2vp9dec"},
};

}  // namespace

DecoderMap hardware_decoders(const std::function<bool(const std::string& element)>& is_usable) {
    DecoderMap chosen;
    for (const Candidate& candidate : candidates)
        if (!chosen.contains(candidate.software) && is_usable(candidate.hardware))
            chosen.emplace(candidate.software, candidate.hardware);
    return chosen;
}

bool is_usable_here(const std::string& element) {
    start_gstreamer();
    const GstPtr<GstElement> decoder(gst_element_factory_make(element.c_str(), nullptr));
    if (!decoder) return false;
    const bool opens = gst_element_set_state(decoder.get(), GST_STATE_READY) != GST_STATE_CHANGE_FAILURE;
    gst_element_set_state(decoder.get(), GST_STATE_NULL);
    return opens;
}

std::string in_words(const DecoderMap& decoders) {
    if (decoders.empty()) return "by the processor";
    std::string words;
    for (const auto& [software, hardware] : decoders)
        words += fmt::format("{}{} instead of {}", words.empty() ? "by " : ", ", hardware, software);
    return words;
}

}  // namespace vitrine::player
