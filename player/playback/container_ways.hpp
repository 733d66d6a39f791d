#pragma once

#include "base/media/media_type.hpp"

namespace vitrine::player {

// Differences between containers in seeking with GStreamer 1.22, as measured.

/// Containers whose time stamps stay right after a seek while the stream time does not. The demuxer of
/// MPEG-TS counts it from the first clock reference instead of the first picture, 0.2 s off and more. No
/// decoder clips a picture of an animation to the segment, so one that began before the seek has no stream
/// time. If the film is read from its start, the two are the same.
inline bool has_true_time_stamps(MediaFormat format) {
    return format == MediaFormat::mpeg_ts || is_animation(format);
}

/// Containers whose times start at zero. In the others they may start anywhere, so the duration does not tell
/// the time of the end.
inline bool starts_at_zero(MediaFormat format) {
    return format != MediaFormat::mpeg_ts;
}

/// Containers whose demuxers can do segment seeks. MPEG-TS stops for ever in one.
inline bool has_segment_seeks(MediaFormat format) {
    return format == MediaFormat::mp4 || format == MediaFormat::matroska || format == MediaFormat::avi;
}

}  // namespace vitrine::player
