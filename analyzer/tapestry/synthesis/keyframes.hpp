#pragma once

#include "analyzer/tapestry/synthesis/affinity.hpp"

#include <chrono>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The frames that one level of a tapestry shows, in time order, as numbers of the frames given.
using Keyframes = std::vector<int>;

struct KeyframeSettings {
    int first = 24;          // keyframes of the coarsest level, n_1
    int growth = 2;          // of their number from level to level, rho
    int most_levels = 32;    // no more are made
    bool keeps_rows = true;  // between two keyframes come new ones in even numbers only
};

/// Keyframes level by level, each level with all those of the one before, until every frame is one, as far as
/// rows allow it. Each level adds those that lower the summed cost of showing every frame by its best
/// keyframe most: pairs greedily, then swaps until none lowers it.
///
/// With keeps_rows a keyframe has an even or an odd number at all levels, which is its row in the brickwork:
/// before the first keyframe and between two of them come new ones in pairs.
///
/// @param costs  of at least one frame
/// Source: Video Tapestries 4.1, k-medoids with earlier levels frozen; 4.3 for the even numbers.
std::vector<Keyframes> keyframe_levels(const Affinity& costs, const KeyframeSettings& settings = {});

/// The same with a first level that is given, by hand or by uniform_keyframes().
std::vector<Keyframes> refined_levels(const Affinity& costs, Keyframes coarsest,
                                      const KeyframeSettings& settings = {});

/// So many frames at equal distances, each in the middle of its part; all of them where there are fewer.
Keyframes uniform_keyframes(int frames, int count);

/// For each time the frame nearest to it, each once, in time order.
Keyframes keyframes_at(std::span<const FrameSignature> frames,
                       std::span<const std::chrono::nanoseconds> times);

}  // namespace vitrine::analyzer
