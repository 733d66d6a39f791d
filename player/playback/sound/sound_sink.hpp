#pragma once

#include "base/media/gst_ptr.hpp"

#include <functional>
#include <string>

namespace vitrine::player {

/// Makes an element that plays raw sound. @throws std::runtime_error where there is none
using SoundSink = std::function<GstPtr<GstElement>()>;

/// A device of ALSA, "default" for the one that ALSA takes.
SoundSink alsa_sink(const std::string& device);

/// A sink behind what makes any raw sound fit for it, as one element with a pad "sink". Within it an element
/// "fade" sees the sound as interleaved floats, with nothing that is decoded ahead between it and the sink.
/// @throws std::runtime_error where they cannot be linked
GstPtr<GstElement> sound_tail(GstElement* sink);

}  // namespace vitrine::player
