#pragma once

#include "analyzer/tapestry/synthesis/run_tasks.hpp"
#include "analyzer/tapestry/synthesis/zoom_part.hpp"

namespace vitrine::analyzer {

struct ZoomRules {
    int between = 35;  // pictures between the levels: .6 s at 60 a second. 4.3 does not say how many
    int rounds = 2;    // of search and votes, a picture
    int radius = 8;    // px of the search
};

/// The zoom of the paper: islands move each at a constant speed, and what is around them is synthesised of
/// both levels' patches, each picture out of the one before, beginning with the finer level. Towards the
/// coarser level islands grow until they are all of it.
///
/// @param left  the last ZoomPart::overlap columns of the part to the left, or empty: the first ones agree
///              with them
/// @return      as wide as ZoomPart::columns(); the first and the last are the levels' own pixels
/// Source: Video Tapestries 4.3. Differs: the guess is bent as the flow goes, not squeezed; a vote counts
/// less the worse its patch matches; what no island has reached towards the end fades.
ZoomPictures synthesised_zoom(const ZoomPart& part, const ZoomWarps& warps, const ZoomPictures& left = {},
                              const ZoomRules& rules = {}, const RunTasks& run = run_in_order);

}  // namespace vitrine::analyzer
