#pragma once

#include "base/media/picture.hpp"
#include "base/system/handle.hpp"

#include <libheif/heif.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

/// A HEIC or AVIF picture, cropped, turned and mirrored as its file asks, 8 bits a channel.
struct HeifPicture {
    int width = 0;  // px
    int height = 0;
    int channels = 3;                   // 3: red, green, blue; 4: and straight alpha
    std::span<const std::byte> pixels;  // rows without gaps, held by image
    std::vector<std::byte> profile;     // ICC; empty: sRGB
    Handle<heif_image, &heif_image_release> image;
};

/// Reads the main picture of a HEIF file with libheif. libvips 8.14 refuses cropped or turned pictures if the
/// file names the crop or the turn before the size.
///
/// The picture is not shrunk while it is decoded: measured at most 6 bytes a pixel.
///
/// @throws MediaError if the file is damaged, has a coding that is not read here, or is beyond the limits of
/// picture.hpp by its header
HeifPicture read_heif(const std::string& path);

/// The EXIF of the main picture, beginning with its TIFF header; empty: it has none. Decodes nothing.
/// @throws MediaError as read_heif()
std::vector<std::byte> heif_exif(const std::string& path);

}  // namespace vitrine
