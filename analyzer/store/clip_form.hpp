#pragma once

#include "analyzer/video/frame_source.hpp"

#include <optional>

namespace vitrine {

/// The pictures of a film's clips: upright, square pixels, even sides.
struct ClipForm {
    int width = 0;  // px
    int height = 0;
    GstVideoOrientationMethod turn = GST_VIDEO_ORIENTATION_IDENTITY;  // that makes the film's frames upright
    GstVideoColorimetry colours{};  // of the film; a clip has those of a usual screen
};

/// @param longest_side  px that a clip has at most
/// @return  nothing where the film is too small for the encoder
std::optional<ClipForm> clip_form(const MediaInfo& film, int longest_side);

/// The longest side of clips where nobody has set it: that of a cell where `slots` shots share a screen 1920
/// px wide, with a third added as pictures reach beyond their cells; between 320 and 1920 px.
int clip_side_for(int slots);

}  // namespace vitrine
