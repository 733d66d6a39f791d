#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/box.hpp"
#include "base/geometry/vec2.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// One frame's saliency within its shot.
struct SalientFrame {
    SaliencyMap map;
    double time = 0;        // since the shot's begin, in the unit of time of the drift (seconds, or frames)
    Vec2 global_motion;     // px of the map per unit of time that the background moves
    Vec2 subject_motion;    // px of the map per unit of time that the salient part moves
    SaliencyMap subject{};  // found by the network; empty where it was not asked
};

/// The saliency of one shot, each frame moved against the drift so that the subject stands still, then added:
/// S_c(u) = sum over f of S_f(u + t_f drift), so u is px of the shot's first instant.
///
/// @param frames  maps of one size, not empty
/// @return        CV_32FC1 of that size; pixels moved in from outside count 0
/// Source: Dynamic Media Assemblage 3.3, eq. 3.3. Differs: sub-pixel shift, bilinear to 1/32 px; time may be
/// uneven.
SaliencyMap accumulated(std::span<const SalientFrame> frames, Vec2 drift);

/// All places of the subject in a shot, in px of the shot's first instant. A subject that the network found
/// in some of the frames is carried to the frames between by the motion of the salient part, and each frame
/// is moved against the drift.
///
/// @param frames  in time order, maps of one size
/// @return        the largest of the moved maps at each place; empty where the network was not asked
SaliencyMap subject_volume(std::span<const SalientFrame> frames, Vec2 drift);

/// The part that every frame of a shot shows once aligned along the drift: the intersection of the moved
/// frames, in px of the first instant.
/// @param duration  duration of the shot, in the unit of time of the drift
Box common_part(cv::Size frame, Vec2 drift, double duration);

/// The drift slowed down so far that the common part keeps at least 60 % of each side.
Vec2 limited_drift(cv::Size frame, Vec2 drift, double duration);

}  // namespace vitrine::analyzer
