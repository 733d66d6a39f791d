#pragma once

#include "base/media/gst_ptr.hpp"

#include <functional>
#include <string>

namespace vitrine::player {

/// Makes an element that plays raw sound. @throws std::runtime_error if none can be made
using SoundSink = std::function<GstPtr<GstElement>()>;

/// Makes a sink for an ALSA device; "default" is the device that ALSA chooses.
SoundSink alsa_sink(const std::string& device);

/// Puts converters in front of a sink, so that it accepts any raw sound. The result is one element with a pad
/// "sink". Its inner element "fade" gets interleaved floats; no queue lies between the fade and the sink, so
/// that no decoded sound waits there.
/// @throws std::runtime_error if they cannot be linked
GstPtr<GstElement> sound_tail(GstElement* sink);

}  // namespace vitrine::player
