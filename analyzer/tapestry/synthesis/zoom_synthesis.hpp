#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"
#include "analyzer/tapestry/synthesis/zoom_part.hpp"

namespace vitrine::analyzer {

struct ZoomRules {
    int between = 35;  // pictures between the levels: .6 s at 60 a second. 4.3 does not say how many
    int rounds = 2;    // rounds of search and votes for each picture
    int radius = 8;    // px that a search reaches
};

/// Makes the zoom of the paper: islands move at constant speeds, and the patches of both levels make up their
/// surroundings. Each picture is made from the one before, beginning with the finer level. Towards the
/// coarser level islands grow until they cover the picture.
///
/// @param left  the last ZoomPart::overlap columns of the part to the left, or empty; the first columns agree
///              with them
/// @return      pictures as wide as ZoomPart::columns(); the first and the last are the levels' own pixels
/// Source: Video Tapestries 4.3. Differs: the first guess is bent along the flow, not scaled; a vote counts
/// less the worse its patch matches; pixels that no island has reached fade towards the end.
ZoomPictures synthesised_zoom(const ZoomPart& part, const ZoomWarps& warps, const ZoomPictures& left = {},
                              const ZoomRules& rules = {}, const RunTasks& run = run_in_order);

}  // namespace vitrine::analyzer
