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

}  // namespace vitrine
