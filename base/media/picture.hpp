#pragma once

#include "base/media/colour.hpp"
#include "base/state/media_error.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace vitrine {

// Limits of photos. A photo beyond them is refused by its header, before it is decoded.
constexpr std::int64_t max_still_pixels = 200'000'000;
constexpr int max_still_side = 65'000;                  // px
constexpr std::int64_t max_bitmap_pixels = 50'000'000;  // BMP cannot be shrunk while it is read

/// The size of a photo.
struct StillInfo {
    int width = 0;  // px, upright (after EXIF or HEIF orientation)
    int height = 0;
};

/// An upright photo, sRGB, RGBA with 8 bits a channel, opaque, rows without gaps.
struct StillPicture {
    int width = 0;  // px
    int height = 0;
    StillInfo full;                 // size before it was shrunk
    std::vector<std::byte> pixels;  // 4 * width * height
};

/// The reasons why a photo is not shown, as far as they matter to the person who put it there.
enum class PictureFailure { cut_short, damaged, too_large, unknown_coding };

/// The state and the text of a failure. The library's own text goes to the debug log: operators cannot use
/// it.
MediaError picture_failure(PictureFailure failure, std::string_view said);

/// @throws MediaError if a photo of this size is too large
void require_within_limits(const StillInfo& info);

}  // namespace vitrine
