#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "analyzer/saliency/subject_outline.hpp"
#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"
#include "base/settings/choices.hpp"

#include <span>

namespace vitrine::analyzer {

/// In hull mode the region encloses the share `mass` of the saliency. In min_area mode it holds as much
/// saliency as fits into `tight_area`, if that is at least the share `mass`; else it holds the share
/// `safe_mass`.
struct RegionSettings {
    RegionMode mode = RegionMode::min_area;
    double mass = 0.64;       // share of the saliency
    double tight_area = 0.4;  // share of the picture
    double safe_mass = 0.95;  // share of the saliency
    double margin = 0.008;    // around the region, share of the picture's diagonal; none in hull mode
};

/// The region of a shot that must not be covered.
///
/// @param volume  accumulated saliency, CV_32FC1, >= 0
/// @param core    px of the volume that every frame of the shot shows; not empty
/// @param faces   px of the volume; each lies wholly inside the result as far as the core reaches; not used
///                in hull mode
/// @return  convex, counter-clockwise, 3 to 12 corners, px of the volume, inside the core. In min_area mode
///          between 8 % and 80 % of the picture, unless core or faces forbid. Where nothing is salient: the
///          middle 60 % of each side.
/// Source: Dynamic Media Assemblage 3.3, which hull mode follows word by word.
Polygon i_region(const SaliencyMap& volume, const Box& core, std::span<const Box> faces,
                 const RegionSettings& settings);

/// The region of a photo whose subject a network has outlined. Where the network is sure, the region follows
/// the outline, whatever its size. Where it doubts, the plain region counts too. Where nothing stands out,
/// the region is large on purpose and holds the share `safe_mass` of the plain saliency.
///
/// @param subject  px of the volume
/// @param volume, core, faces, settings  as for i_region(), in min_area mode
/// @return  convex, counter-clockwise, 3 to 12 corners, px of the volume, inside the core, and at least 5 %
///          of the picture
Polygon subject_region(const SubjectOutline& subject, const SaliencyMap& volume, const Box& core,
                       std::span<const Box> faces, const RegionSettings& settings);

}  // namespace vitrine::analyzer
