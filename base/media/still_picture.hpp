#pragma once

#include "base/media/picture.hpp"

#include <string>

namespace vitrine {

/// Starts libvips, which must not be started by two threads at once; from any thread, as often as one likes.
/// @throws std::runtime_error where it cannot
void init_vips();

/// Reads a photo (of an animation or of several pages the first picture), no larger than max_width x
/// max_height and never enlarged. Memory follows the size asked for where the format allows it (JPEG, PNG,
/// TIFF, WebP).
///
/// @param background  what shows through where the photo is transparent
/// @throws MediaError where the file is no photo, is cut short or damaged, or is beyond the limits
StillPicture load_still(const std::string& path, int max_width, int max_height, Colour background = {});

/// Writes a photo anew, upright and sRGB, its longest side at most so long: a JPEG, or a WebP where it is
/// transparent.
/// @throws MediaError as load_still(), and where the file cannot be written
void save_smaller(const std::string& path, int longest_side, const std::string& to);

}  // namespace vitrine
