#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/tapestry/synthesis/keyframes.hpp"
#include "analyzer/tapestry/weave/candidates.hpp"

#include <functional>
#include <optional>

namespace vitrine::analyzer {

/// The frames of a film that are read once more, larger: the keyframes of its finest level. All others are
/// compared at the size of the analysis, and need no more.
struct SharpFrames {
    int brick_height = 0;  // px
    int frame_size = 0;    // px, longest side of the frames to read
};

/// Says how large keyframes are to be read for bricks of that height, or as tall as the film is; their
/// longest side is at most Candidates::max_side.
SharpFrames frames_as_tall_as(const Candidates& kept, int brick_height);

/// Says how large keyframes are to be read, for bricks as tall as wanted or as the film is.
/// @return nothing where the kept frames are hardly smaller
std::optional<SharpFrames> sharp_frames(const Candidates& kept, int wanted_height);

/// Reads a film to its end and hands on the frames with the times of keyframes.
/// @param source  with frames of SharpFrames::frame_size
void read_sharp_frames(FrameSource& source, const Candidates& kept, const Keyframes& finest,
                       const std::function<void(const FilmFrame&)>& keep);

/// The picture within the film's bars, px of frames of another size.
cv::Rect active_in(const Candidates& kept, cv::Size frame);

/// The levels as numbers of the sharp frames.
/// @param levels  numbers of all frames; the last level is the finest
std::vector<Keyframes> sharp_levels(const std::vector<Keyframes>& levels);

/// Says if sharp frames are those of a finest level.
bool are_frames_of(const Candidates& sharp, const Candidates& kept, const Keyframes& finest);

}  // namespace vitrine::analyzer
