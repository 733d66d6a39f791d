#pragma once

#include "analyzer/tapestry/synthesis/frame_signature.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// A part of a film, half-open [begin, end) in stream time.
struct FilmPart {
    std::chrono::nanoseconds begin{0};
    std::chrono::nanoseconds end{0};
};

/// Returns the root of the mean squared difference: grey levels a channel value, [0, 255].
double difference(const FrameSignature& a, const FrameSignature& b);

/// Tells of each frame if it shows a picture that stands, and so may become a keyframe. Black and empty
/// frames and flashes may not; nor may frames outside the shots that are darker or paler copies of a
/// neighbour, or a mixture of two neighbours: they lie in a fade or a dissolve. Where no frame may, the
/// richest one does.
///
/// @param frames  in time order, at least one
/// @param shots   in time order, not overlapping; none where shots are not known
std::vector<bool> fit_frames(std::span<const FrameSignature> frames, std::span<const FilmPart> shots);

/// Returns the number of the shot of each frame; -1 for frames of shots shorter than a second, and for frames
/// between shots.
std::vector<int> takes_of(std::span<const FrameSignature> frames, std::span<const FilmPart> shots);

}  // namespace vitrine::analyzer
