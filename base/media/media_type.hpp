#pragma once

#include "base/state/record.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace vitrine {

/// The formats that are shown, photos and containers of films. media_type.cpp has the table of the photos and
/// of the bytes by which each format is known.
enum class MediaFormat {
    jpeg,
    png,
    webp,
    heif,  // HEIC and AVIF
    gif,
    tiff,
    bmp,
    mp4,  // QuickTime too
    matroska,
    avi,
    mpeg_ts,
    animated_gif,
    animated_webp,
    animated_png,
};

MediaKind kind_of(MediaFormat format);

/// True for pictures in a photo's format that play as a film.
bool is_animation(MediaFormat format);

/// The format of an animation without regard to its motion; every other format is its own.
MediaFormat still_format(MediaFormat format);

/// True if a photo of this format is decoded as fast as the copy that the store would make of it.
bool is_fast_to_decode(MediaFormat format);

/// Number of bytes at the start of a file that decide its format.
constexpr std::size_t media_head_bytes = 4096;

/// The format of a file by its first bytes. The name of the file does not count.
///
/// An animation is not told from a still.
///
/// @param head  the first bytes of the file, up to media_head_bytes of them
/// @throws MediaError unsupported or waiting; the reason names the kind of file: "this is a web page, not a
/// picture or film"
MediaFormat media_format(std::span<const std::byte> head);

/// The format of the file at `path`. A GIF, WebP or PNG with two pictures or more is an animation.
/// @throws MediaError also if the file is empty, not a regular file, or cannot be read
MediaFormat media_format(const std::string& path);

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

}  // namespace vitrine
