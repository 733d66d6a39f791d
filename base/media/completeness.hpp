#pragma once

#include "base/media/media_type.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace vitrine {

/// The size of a file, and the size that its structure declares. Read without decoding.
struct FileExtent {
    std::uint64_t present = 0;   // bytes of the file
    std::uint64_t declared = 0;  // bytes needed by its boxes or chunks; 0: the format does not tell
    bool has_index = true;       // false: an MP4 without moov, which cannot be played yet
};

FileExtent file_extent(const std::string& path, MediaFormat format);

/// Refuses a file that is still being copied. A decoder does not notice: half a film plays and half a JPEG is
/// decoded (measured with GStreamer 1.22). Holes, as preallocating copies leave them, count as missing.
/// @throws MediaError waiting, with the missing part
void require_complete(const std::string& path, MediaFormat format);

}  // namespace vitrine
