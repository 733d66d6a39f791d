#pragma once

#include "analyzer/saliency/salient_volume.hpp"

#include <span>

namespace vitrine::analyzer {

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

/// The drift along which the shot is accumulated, limited so that the common part keeps at least 60 % of each
/// side.
///
/// @param frames    in time order; none or one make no drift
/// @param duration  of the shot, >= the last frame's time
/// Source: Dynamic Media Assemblage 3.3. Differs in smallest_area: what the flow measured is believed, the
/// background's motion where it carries the subject, else the subject's, unless that spreads the saliency or
/// is faster than the common part allows; then least squares through weighted centroids or a search over all
/// drifts allowed, where they make the area at least 5 % smaller. None moves less than 3 % of the diagonal.
Vec2 found_drift(std::span<const SalientFrame> frames, double duration, DriftMode mode);

}  // namespace vitrine::analyzer
