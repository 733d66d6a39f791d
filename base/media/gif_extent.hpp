#pragma once

#include "base/media/file_bytes.hpp"

#include <cstdint>

namespace vitrine {

/// The number of pictures of a GIF, as far as they are there. @param most  where the counting ends
int gif_pictures(const FileBytes& file, int most);

/// The byte after the last picture of a GIF.
/// @return  beyond the file's end if a picture is cut off; 0 if the file is no GIF up to its end
std::uint64_t gif_end(const FileBytes& file);

}  // namespace vitrine
