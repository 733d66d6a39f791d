#pragma once

#include "base/state/media_origin.hpp"

#include <cstddef>
#include <span>

namespace vitrine::analyzer {

/// Reads the time at which a photo was taken, and the identifier of an Apple Live Photo, with libexif. The
/// zone is the one that the camera wrote; else that between its time and the time of its GPS; else that of
/// this machine. Does not ask if the time is plausible.
/// @param exif  begins with its TIFF header; any bytes
MediaOrigin exif_facts(std::span<const std::byte> exif);

}  // namespace vitrine::analyzer
