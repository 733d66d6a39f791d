#pragma once

#include "base/media/media_type.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace vitrine {

/// What the structure of a file says of itself, without decoding.
struct FileExtent {
    std::uint64_t present = 0;   // bytes of the file
    std::uint64_t declared = 0;  // bytes that its boxes or chunks need; 0: the format does not say
    bool has_index = true;       // false: an MP4 without moov cannot be played yet
};

FileExtent file_extent(const std::string& path, MediaFormat format);

/// Refuses a copy that is still under way: a decoder's success does not show it, for half a film plays and
/// half a JPEG decodes (measured with GStreamer 1.22). Holes, which preallocating copies leave, are seen as
/// well.
/// @throws MediaError waiting, with what is missing
void require_complete(const std::string& path, MediaFormat format);

}  // namespace vitrine
