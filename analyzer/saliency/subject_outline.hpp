#pragma once

#include "analyzer/saliency/saliency_map.hpp"
#include "base/geometry/polygon.hpp"

namespace vitrine::analyzer {

constexpr double sure_certainty = 0.7;   // from here on the outline alone makes the region
constexpr double blind_certainty = 0.5;  // below, nothing stands out

/// The outline of a picture's subject, as a network sees it.
struct SubjectOutline {
    Polygon sure;      // convex, px of the map: hull of all that is rather the subject than not, and of
                       // fainter things that stand apart from it
    Polygon possible;  // convex: also what may be the subject. Both have no corners where nothing stands out
    double certainty = 0;  // [0, 1]: 1 where the map is black and white, with one outline at any threshold
};

/// Finds the outline of a map that a network has made. Where all is faint nothing stands out. Specks, parts
/// with less than a twentieth of the mass of the heaviest part, do not count.
///
/// The doubt is the share of undecided mass, U = sum m (1 - m) / sum m. A small subject is a blur as wide as
/// itself, and undecided by that measure. So the doubt is no larger than twice the growth of the outline's
/// size, as a share of the picture's side, from a high threshold to a low one. The certainty is 1 - doubt.
/// @param map  CV_32FC1 in [0, 1]
SubjectOutline subject_outline(const SaliencyMap& map);

}  // namespace vitrine::analyzer
