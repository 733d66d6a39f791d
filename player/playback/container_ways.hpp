#pragma once

#include "base/media/media_type.hpp"

namespace vitrine::player {

// Differences between containers in seeking with GStreamer 1.22, as measured.

/// Containers whose time stamps stay true over a seek while the demuxer's stream time does not: it is then
/// counted from the first clock reference instead of the first picture, 0.2 s off and more. In a pass from
/// the begin the two are the same.
inline bool has_true_time_stamps(MediaFormat format) {
    return format == MediaFormat::mpeg_ts;
}

/// Containers whose times may begin anywhere, so that their duration does not tell where they end.
inline bool starts_at_zero(MediaFormat format) {
    return format != MediaFormat::mpeg_ts && format != MediaFormat::mpeg_ps;
}

/// Containers whose demuxers keep their promise in segment seeks; MPEG-TS stands still for ever.
inline bool has_segment_seeks(MediaFormat format) {
    return format == MediaFormat::mp4 || format == MediaFormat::matroska || format == MediaFormat::avi;
}

}  // namespace vitrine::player
