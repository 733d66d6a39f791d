#pragma once

#include "analyzer/film/frame_source.hpp"
#include "base/media/still_picture.hpp"

#include <memory>
#include <string>

namespace vitrine::analyzer {

/// Opens a photo (one frame) or a film (all its frames) for analysis: upright, square pixels, BGR.
///
/// The source's info().duration is the one that the container declares; after next() has given nothing, it is
/// the end of the last frame. Memory does not grow with the film's length. A film that gives no frame for a
/// while is an error (film_source.hpp has the limits).
///
/// @param analysis_size  px, the longest side of a film's frames; a photo has twice as many, like
///                       the finer pictures of a film. Smaller media keep their size
/// @param background     colour that shows through where the medium is transparent
/// @throws MediaError    where the file is no medium, is not complete, is damaged or beyond the limits
std::unique_ptr<FrameSource> open_media(const std::string& path, int analysis_size = 320,
                                        Colour background = {});

}  // namespace vitrine::analyzer
