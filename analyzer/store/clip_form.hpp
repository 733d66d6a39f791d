#pragma once

#include "analyzer/film/frame_source.hpp"

#include <optional>

namespace vitrine::analyzer {

/// The format of a film's clips: upright, square pixels, even sides.
struct ClipForm {
    int width = 0;  // px
    int height = 0;
    GstVideoOrientationMethod turn = GST_VIDEO_ORIENTATION_IDENTITY;  // makes the film's frames upright
    GstVideoColorimetry colours{};  // the film's; a clip has those of a usual screen
};

/// @param max_side  px, of a clip's longest side
/// @return  nothing where the film is too small for the encoder
std::optional<ClipForm> clip_form(const MediaInfo& film, int max_side);

/// The longest side of clips where nobody has set it: that of a cell where `slots` shots share a screen, with
/// a fifth added as pictures reach beyond their cells; at least 320 px, at most the screen's.
/// @param screen_side  px of the screen's longest side; 0: not known, taken for 1920
int clip_side_for(int slots, int screen_side = 0);

}  // namespace vitrine::analyzer
