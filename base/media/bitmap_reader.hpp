#pragma once

#include "base/media/picture.hpp"

#include <string>

namespace vitrine {

/// Reads a Windows bitmap (BMP) of 1, 4, 8, 16, 24 or 32 bits a pixel, not run-length coded. libvips reads
/// none itself and would hand it to ImageMagick, which is too large a door for eighty lines.
///
/// @return  the picture at full size, opaque RGBA
/// @throws MediaError where it is cut short, run-length coded or beyond max_bitmap_pixels
StillPicture read_bitmap(const std::string& path);

}  // namespace vitrine
