#pragma once

#include "base/media/file_bytes.hpp"

#include <cstdint>

namespace vitrine {

/// The byte after the last picture of a GIF, also of an animated one, whose first picture only is shown.
/// @return  beyond the file's end if a picture is cut off; 0 if the file is no GIF up to its end
std::uint64_t gif_end(const FileBytes& file);

}  // namespace vitrine
