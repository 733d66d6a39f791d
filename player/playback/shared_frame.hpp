#pragma once

#include "player/playback/sample.hpp"

#include <gst/video/video.h>

#include <optional>

namespace vitrine::player {

/// A sample that refers to a decoded frame's planes in shared memory, without copying them. None: the memory
/// is not shared, or the layout is neither I420 nor NV12. The order of the pixels comes from the caps
/// (drm-format, GStreamer 1.24 and later). Older caps say only memory:DMABuf and not the order, so such
/// frames are not asked for. The sample owns the frame; it has the film's colours and no bytes.
std::optional<Sample> shared_frame(GstSample* frame);

/// The colours of a film, as the renderer needs them.
ColourCode colour_code(const GstVideoColorimetry& colours);

/// Tells the decoder before a pad that any placement of the planes is accepted; else a hardware decoder would
/// copy them.
void let_planes_lie(GstPad* pad);

}  // namespace vitrine::player
