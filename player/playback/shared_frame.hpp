#pragma once

#include "player/playback/sample.hpp"

#include <gst/gst.h>

#include <optional>

namespace vitrine::player {

/// A decoded frame where its planes lie, without reading it; nothing where they do not lie in memory that is
/// shared, or in another layout than I420 or NV12. How the pixels lie is taken from the caps (drm-format, of
/// GStreamer 1.24 and later); the earlier caps that only say memory:DMABuf do not tell, so such frames are
/// not asked for. The sample has the frame for its owner, the film's colours and no bytes.
std::optional<Sample> shared_frame(GstSample* frame);

/// Tells decoders before a pad that planes may lie as they like, or those in hardware would copy them.
void let_planes_lie(GstPad* pad);

}  // namespace vitrine::player
