#pragma once

#include "player/display/gl_device.hpp"
#include "player/playback/sample.hpp"

#include <string_view>

namespace vitrine::player {

/// The form for uploading pictures. If the processor draws, each operation on a pixel is expensive, so the
/// pictures are prepared for plain copying. A graphics card gets less data to carry, or none.
/// @param device               gl_device()
/// @param reads_shared_planes  true: decoders' pictures can be drawn in place
inline PictureForm picture_form(std::string_view device, bool reads_shared_planes) {
    if (is_software(device)) return PictureForm::bgra;
    return reads_shared_planes ? PictureForm::shared : PictureForm::planes;
}

/// The form in words, for the log.
inline const char* in_words(PictureForm form) {
    switch (form) {
    case PictureForm::bgra:
        return "scaled by the processor, which draws too";
    case PictureForm::planes:
        return "uploaded as they are decoded, scaled by the graphics card";
    case PictureForm::shared:
        break;
    }
    return "drawn from where a decoder shares them, else uploaded as they are decoded";
}

}  // namespace vitrine::player
