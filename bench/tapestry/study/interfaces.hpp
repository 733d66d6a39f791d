#pragma once

#include "base/state/tapestry.hpp"
#include "bench/tapestry/study/searcher.hpp"

#include <filesystem>
#include <map>

namespace vitrine::study {

// Three interfaces as a screen of 1920 x 1080 px draws them, at a quarter of its size. The film stands above.

/// Frames of a film by stream time, BGR.
using FrameTable = std::map<std::chrono::nanoseconds, cv::Mat>;

/// A tapestry with all its levels.
/// @param directory  of the tapestry
/// @param shape      size of the film's picture; only its shape counts
/// @throws std::runtime_error that names a tile that cannot be read
SearchedInterface tapestry_interface(const std::filesystem::path& directory, const Tapestry& tapestry,
                                     cv::Size shape);

/// The moments of a filmstrip's frames: for every level of the tapestry as many as fit beside each other at
/// its height and in its width, evenly spaced.
std::vector<std::vector<std::chrono::nanoseconds>> filmstrip_times(const Tapestry& tapestry, cv::Size shape);

/// Whole frames side by side, as tall as the tapestry, with levels as wide as the tapestry's.
/// @param frames  hold one of each of the times, the nearest not before it
SearchedInterface filmstrip_interface(const Tapestry& tapestry, cv::Size shape, const FrameTable& frames);

/// A line: nothing of the film is drawn in it.
SearchedInterface scrollbar_interface(const Tapestry& tapestry);

}  // namespace vitrine::study
