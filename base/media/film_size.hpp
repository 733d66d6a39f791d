#pragma once

#include <gst/gst.h>

#include <cstdint>

namespace vitrine {

/// Limits of a film's pictures.
constexpr int max_film_side = 16'384;                 // px
constexpr std::int64_t max_film_pixels = 40'000'000;  // 8K is 33 million

/// Watches the pictures that arrive at a pad of a film's pipeline, coded or raw. At the first picture beyond
/// the limits, or far larger than the film's first and than 1080p, the pad's element posts an error, and from
/// then on nothing passes the pad. So a decoder makes no room for a picture that is too large, wherever in
/// the film it stands. The size is that of the stream's caps; for VP8 and VP9 it is also read from each
/// picture.
/// @param mark  marks the message, see post_error(); its code is GST_STREAM_ERROR_NOT_IMPLEMENTED
void limit_picture_size(GstPad* pad, const char* mark);

}  // namespace vitrine
