#pragma once

#include "player/layout/edit/wall_state.hpp"

#include <cstddef>
#include <optional>

namespace vitrine::player {

// Each edit is a change plan (plan/flat_plan.hpp) in which only the edited item is free to change its place.
//
// Every edit succeeds. Its result is free of overlap, inside the canvas and final. The others move as little
// as possible. An item without room becomes smaller: first the newcomer or the touched item, then all that
// are not pinned. The same wall, edit and seed give the same result.
// Source: docs/algorithms.md, (d) "Slots rotating"; the paper packs anew (3.4), which moves everything.

/// Adds a newcomer at a place, or at the emptiest place. It becomes the last item. @param at  canvas px
WallState inserted(const WallState& wall, const LayoutItem& newcomer, const EditRules& rules = {},
                   std::optional<Vec2> at = std::nullopt);

/// Removes an item. The others grow into its room.
WallState deleted(const WallState& wall, std::size_t item, const EditRules& rules = {});

/// Replaces a slot's shot by its next one, at the same place and with the same area.
WallState replaced(const WallState& wall, std::size_t item, const LayoutItem& newcomer,
                   const EditRules& rules = {});

/// Makes one step of a drag. The item's centroid goes to a place, as near as pinned items and the canvas
/// allow; the others make room; the items that it has passed return. settled() ends the drag.
/// @param to  canvas px
WallState dragged(const WallState& wall, std::size_t item, Vec2 to, const EditRules& rules = {});

/// Resizes an item about its place, as near to the wish as possible.
/// @param factor  factor of its scale, > 0
WallState resized(const WallState& wall, std::size_t item, double factor, const EditRules& rules = {});

/// Makes the present place of each item its home. Items that became small grow again.
WallState settled(const WallState& wall, const EditRules& rules = {});

}  // namespace vitrine::player
