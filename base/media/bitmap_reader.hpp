#pragma once

#include "base/media/picture.hpp"

#include <string>

namespace vitrine {

/// Reads a Windows bitmap (BMP) of 1, 4, 8, 16, 24 or 32 bits a pixel without run-length coding. libvips does
/// not read bitmaps: it passes them to ImageMagick, which is far more code that strangers' files could
/// attack.
///
/// @return  the picture at full size, opaque RGBA
/// @throws MediaError if the file is cut short, run-length coded, or beyond max_bitmap_pixels
StillPicture read_bitmap(const std::string& path);

}  // namespace vitrine
