#pragma once

#include "base/media/colour.hpp"

#include <cstddef>
#include <cstdint>
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

}  // namespace vitrine
