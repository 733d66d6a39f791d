#pragma once

#include "base/media/media_type.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The EXIF of a photo as the camera wrote it, beginning with its TIFF header. Empty: the photo has none, or
/// its format is none of JPEG, HEIC, AVIF, PNG and WebP.
/// @throws MediaError where the file cannot be read
std::vector<std::byte> exif_block(const std::string& path, MediaFormat format);

}  // namespace vitrine::analyzer
