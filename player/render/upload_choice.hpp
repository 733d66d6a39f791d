#pragma once

#include "player/playback/sample.hpp"

#include <string_view>

namespace vitrine {

/// What pictures are to be uploaded as: where the processor draws, each operation on a pixel is dear, so that
/// it gets them ready for copying; a graphics card gets less to carry.
/// @param renderer  GL's name of it
inline PictureForm picture_form(std::string_view renderer) {
    for (const std::string_view processor : {"llvmpipe", "softpipe", "SwiftShader", "swrast", "Software"})
        if (renderer.find(processor) != std::string_view::npos) return PictureForm::rgba;
    return PictureForm::planes;
}

}  // namespace vitrine
