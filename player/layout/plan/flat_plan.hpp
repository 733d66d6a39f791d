#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <functional>

namespace vitrine::player {

/// Who watches a plan being made. Both may be empty.
struct PlanWatch {
    std::function<void(const Layout&)> on_better;  // each is complete and free of overlap
    std::function<bool()> should_stop;             // asked about every 1000 moves
};

/// Where every item shall stand. In every layout, also those told to `on_better`, the I-Regions lie whole
/// inside the canvas, pairwise at least `clearance` apart (pinned items among themselves excepted).
///
/// With no previous placement: initial packing, then growing and separating. Otherwise kept items move as
/// little as possible: newcomers enter at their seat or where most room is, and only what is in their way
/// makes room. At last, unless the request says otherwise, what is left over is used up (filling.hpp).
/// Source: Dynamic Media Assemblage 3.4; ALGORITHMS (d) "Slots rotating". Differs from eq. 3.4: overlap has
/// no price, it does not occur; what is minimised is the share of the screen without I-Regions, and then
/// what filling.hpp adds to it.
Layout plan(const PlanRequest& request, const PlanWatch& watch = {});

/// The same for a wall some of whose items stand, without ever packing it anew.
/// @return none where nothing stands, or where pinned items leave no room
std::optional<Layout> plan_change(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
