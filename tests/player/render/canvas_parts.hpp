#pragma once

#include <cstdint>

namespace vitrine::player {

/// The difference between a canvas drawn as a whole and its parts, each drawn on a screen of its own.
struct PartsDifference {
    int frames = 0;
    int channel = 0;        // the farthest channel of a pixel, levels
    std::uint64_t odd = 0;  // pixels with a channel that is more than one level off
};

/// Draws frames of changes and drags of walls both ways.
/// @param frames  how many at least
PartsDifference compare_parts(int frames, std::uint64_t seed);

}  // namespace vitrine::player
