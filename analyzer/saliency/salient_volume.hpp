#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/box.hpp"
#include "base/geometry/vec2.hpp"

#include <span>
#include <vector>

namespace vitrine {

/// One frame's saliency within its shot.
struct SalientFrame {
    SaliencyMap map;
    double time = 0;     // since the shot's begin, in the unit drifts are given in (seconds, or frames)
    Vec2 global_motion;  // px of the map per unit of time that the background moves
};

/// How the direction is found along which a shot's saliency is added.
enum class DriftMode {
    none,         // the region stands still
    box_centres,  // the paper's: least squares through the centres of the boxes around each frame's top half
    smallest_area,  // of several candidates the one that concentrates saliency most; still unless it is worth
                    // it
};

/// The bounding box of a frame's most salient pixels that together hold half its saliency, px of the map;
/// the whole map where nothing is salient.
/// Source: Dynamic Media Assemblage 3.3.
Box half_mass_box(const SaliencyMap& map);

/// The saliency of one shot, each frame moved against the drift so that the subject stands still, then added:
/// S_c(u) = sum over f of S_f(u + t_f drift), so u is px of the shot's first instant.
///
/// @param frames  maps of one size, not empty
/// @return        CV_32FC1 of that size; pixels moved in from outside count 0
/// Source: Dynamic Media Assemblage 3.3, eq. 3.3. Differs: sub-pixel shift, bilinear to 1/32 px; time may be
/// uneven.
SaliencyMap accumulated(std::span<const SalientFrame> frames, Vec2 drift);

/// What every frame of a shot shows once aligned along the drift: the intersection of the moved frames, in px
/// of the first instant. @param duration  of the shot, in the unit of time of the drift
Box common_part(cv::Size frame, Vec2 drift, double duration);

/// The drift along which the shot is accumulated, limited so that the common part keeps at least 60 % of each
/// side.
///
/// @param frames    in time order; none or one make no drift
/// @param duration  of the shot, >= the last frame's time
/// Source: Dynamic Media Assemblage 3.3. Differs in smallest_area: candidates are standing still, least
/// squares through weighted centroids, the median global motion and a search over all drifts allowed; one is
/// taken only if it makes the area at least 5 % smaller and moves at least 3 % of the diagonal.
Vec2 found_drift(std::span<const SalientFrame> frames, double duration, DriftMode mode);

}  // namespace vitrine
