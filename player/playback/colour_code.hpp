#pragma once

#include "player/playback/sample.hpp"

#include <gst/video/video.h>

namespace vitrine::player {

inline ColourCode colour_code(const GstVideoColorimetry& colours) {
    ColourCode code{.is_full_range = colours.range == GST_VIDEO_COLOR_RANGE_0_255};
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT709) code.matrix = ColourCode::Matrix::bt709;
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT2020) code.matrix = ColourCode::Matrix::bt2020;
    return code;
}

}  // namespace vitrine::player
