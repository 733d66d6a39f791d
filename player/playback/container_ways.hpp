#pragma once

#include "base/media/media_type.hpp"

namespace vitrine::player {

// Differences between containers in seeking with GStreamer 1.22, as measured.

/// Containers whose time stamps stay right after a seek while the demuxer's stream time does not: after a
/// seek it counts from the first clock reference instead of the first picture, 0.2 s off and more. If the
/// film is read from its start, the two are the same.
inline bool has_true_time_stamps(MediaFormat format) {
    return format == MediaFormat::mpeg_ts;
}

/// Containers whose times start at zero. In the others they may start anywhere, so the duration does not tell
/// the time of the end.
inline bool starts_at_zero(MediaFormat format) {
    return format != MediaFormat::mpeg_ts && format != MediaFormat::mpeg_ps;
}

/// Containers whose demuxers can do segment seeks. MPEG-TS stops for ever in one.
inline bool has_segment_seeks(MediaFormat format) {
    return format == MediaFormat::mp4 || format == MediaFormat::matroska || format == MediaFormat::avi;
}

}  // namespace vitrine::player
