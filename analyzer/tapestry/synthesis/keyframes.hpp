#pragma once

#include "analyzer/tapestry/synthesis/affinity.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The frames that one level of a tapestry shows, in time order, as numbers of the frames given.
using Keyframes = std::vector<int>;

/// Keeps out keyframes that tell nothing. The amounts hold for the coarsest level; each finer level asks for
/// a quarter of the gain and half of the difference of the one before.
struct KeyframeRules {
    std::span<const FrameSignature> frames;  // outlive the choice
    std::vector<bool> fit;                   // frames that may become keyframes
    std::vector<int> takes;                  // the take of each frame, -1: of none that must be shown
    double min_gain = 500;       // squared grey levels, summed over the frames that it shows better
    double min_difference = 20;  // grey levels to the neighbours, except for the first keyframe of a take
};

struct KeyframeSettings {
    int first = 24;          // keyframes of the coarsest level, n_1, at most
    int max_first = 36;      // the same with rules, where so many tell all
    int min_first = 4;       // with rules: coarser levels are left out, since they fill no screen
    int growth = 2;          // factor from each level to the next, rho
    int max_levels = 32;     // the coarsest included
    bool keeps_rows = true;  // new keyframes between two others come in even numbers only
    std::optional<KeyframeRules> rules;
    Keyframes chosen{};  // by a person: keyframes of the coarsest level, whatever they show
};

/// Chooses keyframes level by level, until every frame is a keyframe as far as rows allow it. Each level
/// holds all keyframes of the one before. It adds those that lower most the summed cost of showing every
/// frame by its best keyframe: first pairs greedily, then swaps until none lowers it.
///
/// With keeps_rows the number of a keyframe is even at all levels or odd at all levels, so that it stays in
/// its row of the brickwork: new keyframes before the first one and between two others come in pairs.
///
/// With rules there are as many keyframes as the film has to tell: none is added that lowers the cost by too
/// little or looks like its neighbour. A take has a keyframe of its own. Frames that are not fit need not be
/// shown. A level that would add less than a third to the one before is left out, and the next one is finer.
///
/// Frames that a person has chosen are keyframes of the coarsest level, beside those that it would have.
///
/// @param costs  costs of at least one frame
/// Source: Video Tapestries 4.1, k-medoids with earlier levels frozen; 4.3 for the even numbers.
std::vector<Keyframes> keyframe_levels(Affinity costs, const KeyframeSettings& settings = {});

/// Chooses the finer levels for a first level that is given, by hand or by uniform_keyframes().
std::vector<Keyframes> refined_levels(Affinity costs, Keyframes coarsest,
                                      const KeyframeSettings& settings = {});

/// Chooses `count` frames at equal distances, each in the middle of its part; all frames where there are
/// fewer.
Keyframes uniform_keyframes(int frames, int count);

/// Chooses the frame nearest to each time, each frame once, in time order.
Keyframes keyframes_at(std::span<const FrameSignature> frames,
                       std::span<const std::chrono::nanoseconds> times);

}  // namespace vitrine::analyzer
