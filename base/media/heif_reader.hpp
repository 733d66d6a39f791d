#pragma once

#include "base/media/picture.hpp"
#include "base/system/handle.hpp"

#include <libheif/heif.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// A HEIC or AVIF picture as its file wants it seen: cropped, turned and mirrored, 8 bits a channel.
struct HeifPicture {
    int width = 0;  // px
    int height = 0;
    int channels = 3;                   // red, green, blue and, where there are four, straight alpha
    std::span<const std::byte> pixels;  // rows without gaps, held by image
    std::vector<std::byte> profile;     // ICC; empty: sRGB
    Handle<heif_image, &heif_image_release> image;
};

/// Reads the main picture of a HEIF file with libheif. libvips 8.14 refuses what is cropped or turned where
/// the file says so before it says its size.
///
/// Nothing is shrunk while it is decoded: measured 6 bytes a pixel at the most.
///
/// @throws MediaError where it is damaged, of a coding that is not read here, or beyond the limits of
/// picture.hpp by its header
HeifPicture read_heif(const std::string& path);

}  // namespace vitrine
