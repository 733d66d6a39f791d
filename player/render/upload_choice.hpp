#pragma once

#include "player/display/gl_device.hpp"
#include "player/playback/sample.hpp"

#include <string_view>

namespace vitrine {

/// What pictures are to be uploaded as: where the processor draws, each operation on a pixel is dear, so that
/// it gets them ready for copying; a graphics card gets less to carry.
/// @param device  gl_device()
inline PictureForm picture_form(std::string_view device) {
    return is_software(device) ? PictureForm::rgba : PictureForm::planes;
}

}  // namespace vitrine
