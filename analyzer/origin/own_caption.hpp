#pragma once

#include "base/media/media_type.hpp"

#include <string>
#include <string_view>

namespace vitrine::analyzer {

/// The caption that somebody wrote into a photo, one line of UTF-8: IPTC's, else that of XMP, else EXIF's
/// description or comment. Texts that cameras write by themselves are none, and neither are those that are
/// longer than captions may be. Empty: there is none, or the format is none of JPEG, HEIC, AVIF, PNG, TIFF
/// and WebP. Does not throw for a damaged file. Parses with Exiv2: call it in the sandbox only.
std::string own_caption(const std::string& path, MediaFormat format);

/// A text in UTF-8: as it is where it is valid, else read as Latin-1 with Windows' further letters.
std::string to_utf8(std::string_view text);

/// True for what cameras and programs write where nobody wrote a caption: "OLYMPUS DIGITAL CAMERA".
bool is_camera_text(std::string_view text);

}  // namespace vitrine::analyzer
