#pragma once

#include "analyzer/tapestry/weave/film_weave.hpp"
#include "analyzer/tapestry/weave/sharp_frames.hpp"

namespace vitrine::analyzer {

/// One level of a tapestry as one picture, to be printed.
struct Poster {
    cv::Mat picture;         // CV_8UC3
    double enlargement = 1;  // of the frames' pixels; 1: they are not enlarged
};

/// Says how large keyframes are to be read for a poster of that height, or as large as the film is.
/// @param keyframes  number of keyframes of the poster
SharpFrames poster_frames(const Candidates& kept, int height, std::size_t keyframes);

/// Weaves keyframes into a poster of exactly that height. Where they are too small for it they are woven as
/// they are, and the whole is enlarged.
/// @param film  frames of the size of poster_frames()
Poster drawn_poster(const Film& film, const Keyframes& keyframes, int height, const RunTasks& run);

}  // namespace vitrine::analyzer
