#pragma once

#include "player/layout/plan/plan_request.hpp"

namespace vitrine::player {

// The door to all packing: items and a canvas go in, a layout comes out. plan() chooses one of five ways:
//
//   request                    module      way
//   keeps_places               kept_layout the items' places, where all have one and these are sound
//   items have groups          nesting     each group is one body; its items are packed in the body
//   energy = paper             flat_plan   eq. 3.4-3.7: pack/initial_packing, then pack/descent, down the
//                                          paper_energy() of pack/energy
//   placed items may move      warm_start  newcomers are let in, the others move as little as possible
//   else (the default path)    flat_plan   pack/initial_packing, pack/line_packing for a reading order, or
//                                          pack/separation round pinned items; then pack/optimizer
//
// Where pinned items are the only placed ones, the others are planned without them, and then make room for
// them: that fills the canvas better than to pack around them.
//
// All ways but the paper's end with pack/filling, which moves and resizes items so that pictures fill the
// canvas. Other entries: `planner` makes plans on a thread of its own; `ribbon` plans a panning wall screen
// by screen; edit/edit changes a wall that is touched. cells/cells then gives each item its cell.

/// The layout of a request. In every layout, also those for `on_better`, the I-Regions are completely inside
/// the canvas and at least `clearance` apart, and none is under a band of the canvas. Exception: pinned items
/// may overlap each other and the bands.
///
/// Source: Dynamic Media Assemblage 3.4; docs/algorithms.md, (d) "Slots rotating". Differs from eq. 3.4:
/// overlap has no price, because it does not occur. The plan minimises the share of the screen without
/// I-Regions, and at last the costs of filling.hpp.
Layout plan(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
