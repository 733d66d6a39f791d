#pragma once

#include "base/media/animation.hpp"

#include <gst/gst.h>

#include <memory>
#include <string>

namespace vitrine {

/// Opens an animation at its first picture.
/// @param background  the colour behind transparent parts
/// @throws MediaError if the file is damaged or cut short, or beyond the limits
std::unique_ptr<AnimationReader> open_animation(const std::string& path, MediaFormat format,
                                                Colour background = {});

/// Makes an element in a bin, which owns it, that gives the pictures of an animation as raw video, each at
/// its time and for its duration. It can seek.
/// @param mark  marks the messages of its errors, see post_error()
/// @throws MediaError if the file is damaged or cut short, or beyond the limits of an animation
GstElement* add_animation_source(GstBin* bin, const std::string& path, MediaFormat format, const char* mark);

}  // namespace vitrine
