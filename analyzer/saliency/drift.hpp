#pragma once

#include "analyzer/saliency/salient_volume.hpp"

#include <span>

namespace vitrine::analyzer {

/// The way in which the drift of a shot is found, along which its saliency is added.
enum class DriftMode {
    none,         // the region stands still
    box_centres,  // the paper's: least squares through the centres of the boxes around each frame's top half
    smallest_area,  // the candidate that concentrates saliency most; still unless it gains enough
};

/// The bounding box of a frame's most salient pixels that together hold half its saliency, px of the map;
/// the whole map where nothing is salient.
/// Source: Dynamic Media Assemblage 3.3.
Box half_mass_box(const SaliencyMap& map);

/// The drift along which the shot is accumulated, limited so that the common part keeps at least 60 % of each
/// side.
///
/// @param frames    in time order; none or one make no drift
/// @param duration  duration of the shot, >= the last frame's time
/// Source: Dynamic Media Assemblage 3.3. Differs in smallest_area: the flow's motion is used - the
/// background's where it carries the subject, else the subject's - unless it spreads the saliency or is
/// faster than the common part allows. Then least squares through weighted centroids or a search over all
/// drifts allowed is used, where they make the area at least 5 % smaller. A drift of less than 3 % of the
/// diagonal counts as none.
Vec2 found_drift(std::span<const SalientFrame> frames, double duration, DriftMode mode);

}  // namespace vitrine::analyzer
