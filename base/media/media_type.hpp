#pragma once

#include "base/state/record.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace vitrine {

/// The formats that are shown: still pictures first, then film containers.
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
    mpeg_ps,
    ogg,
    flv,
    asf,
    mxf,
};

MediaKind kind_of(MediaFormat format);

/// So many first bytes decide what a file is.
constexpr std::size_t media_head_bytes = 4096;

/// What a file is by its first bytes, never by its name.
///
/// @param head  the first bytes of the file, up to media_head_bytes of them
/// @throws MediaError unsupported or waiting, with what it is instead: "this is a web page, not a picture or
/// film"
MediaFormat media_format(std::span<const std::byte> head);

/// The same of the file at `path`.
/// @throws MediaError also where it is empty, no regular file or cannot be read
MediaFormat media_format(const std::string& path);

}  // namespace vitrine
