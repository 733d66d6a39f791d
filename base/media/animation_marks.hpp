#pragma once

#include "base/media/file_bytes.hpp"

namespace vitrine {

// Tells animations from stills by their structure; nothing is decoded.

/// True if a GIF has two pictures or more.
bool is_animated_gif(const FileBytes& file);

/// True if a WebP has two pictures or more.
bool is_animated_webp(const FileBytes& file);

/// True if a PNG says before its first picture that it has two or more (APNG).
bool is_animated_png(const FileBytes& file);

}  // namespace vitrine
