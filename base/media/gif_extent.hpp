#pragma once

#include "base/media/file_bytes.hpp"

#include <cstdint>

namespace vitrine {

/// Where a GIF ends: of an animated one, whose first picture alone is shown, behind the last. Beyond the
/// file's end where a picture is cut off; 0 where this is no GIF to its end.
std::uint64_t gif_end(const FileBytes& file);

}  // namespace vitrine
