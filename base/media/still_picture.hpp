#pragma once

#include "base/media/picture.hpp"

#include <string>

namespace vitrine {

/// Starts libvips, which two threads must not start at once. Thread-safe; calls after the first do nothing.
/// @throws std::runtime_error if libvips cannot start
void init_vips();

/// Starts libvips for reading strangers' files: only with loaders that are fuzzed, without a cache, in one
/// thread. Thread-safe; calls after the first do nothing. @throws std::runtime_error if libvips cannot start
void start_vips();

/// Reads a photo, shrunk to at most max_width x max_height, never enlarged. Of an animation or a file with
/// several pages, reads the first picture. Memory follows the requested size if the format allows it (JPEG,
/// PNG, TIFF, WebP).
///
/// @param background  the colour behind transparent parts
/// @throws MediaError if the file is no photo, is cut short or damaged, or is beyond the limits
StillPicture load_still(const std::string& path, int max_width, int max_height, Colour background = {});

/// Writes a smaller photo, upright and in sRGB: a WebP if it is transparent, else a JPEG.
/// @param max_side  px, for the longest side
/// @throws MediaError like load_still(), and if the file cannot be written
void save_smaller(const std::string& path, int max_side, const std::string& to);

}  // namespace vitrine
