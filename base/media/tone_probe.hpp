#pragma once

#include "base/media/gst_ptr.hpp"

namespace vitrine {

/// Makes a tail show HDR and wide films as a usual screen can, as the analysis sees them: where the frames
/// that enter it need it (tone_map.hpp), those that reach its sink are changed in place. Other films pass
/// untouched.
///
/// @param tail  the tail of a DecodeChain, see make_bin()
/// @param sink  the element at its end, which is given RGBA
void map_tones(GstElement* tail, GstElement* sink);

}  // namespace vitrine
