#pragma once

#include "player/layout/edit/wall_state.hpp"

#include <cstddef>
#include <optional>

namespace vitrine::player {

// Each edit is a change plan (plan/flat_plan.hpp) in which everything stands but what is edited.
//
// Every edit succeeds, and its result is free of overlap, inside the canvas and final. The others move as
// little as they can. An item that finds no room becomes smaller: first the newcomer or the item that is
// touched, then all that are not pinned. The same wall, edit and seed give the same result.
// Source: docs/algorithms.md, (d) "Slots rotating"; the paper packs anew (3.4), which moves everything.

/// A newcomer comes in at a place, or where most room is; it is the last item. @param at  canvas px
WallState inserted(const WallState& wall, const LayoutItem& newcomer, const EditRules& rules = {},
                   std::optional<Vec2> at = std::nullopt);

/// An item leaves; the others grow into its room.
WallState deleted(const WallState& wall, std::size_t item, const EditRules& rules = {});

/// A slot's next shot takes over the place and the area of the last.
WallState replaced(const WallState& wall, std::size_t item, const LayoutItem& newcomer,
                   const EditRules& rules = {});

/// One step of a drag: the item's centroid goes to a place as near as pinned items and the canvas allow, the
/// others make way, and the items that it has passed go back. settled() ends the drag.
/// @param to  canvas px
WallState dragged(const WallState& wall, std::size_t item, Vec2 to, const EditRules& rules = {});

/// The item becomes larger or smaller about its place, as near to the wish as is possible.
/// @param factor  of its scale, > 0
WallState resized(const WallState& wall, std::size_t item, double factor, const EditRules& rules = {});

/// The present place of each item becomes its home; items that have become small grow again.
WallState settled(const WallState& wall, const EditRules& rules = {});

}  // namespace vitrine::player
