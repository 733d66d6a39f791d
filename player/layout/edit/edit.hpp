#pragma once

#include "player/layout/edit/wall_state.hpp"

#include <cstddef>
#include <optional>

namespace vitrine::player {

/// A layout as it stands, nothing pinned. @pre a placement an item
Standing standing(std::vector<LayoutItem> items, const Layout& layout);

/// The wall as a layout.
Layout layout_of(const Standing& wall);

/// A newcomer comes in at a place, or where most room is; it is the last item. @param at  canvas px
Standing inserted(const Standing& wall, const LayoutItem& newcomer, const EditRules& rules = {},
                  std::optional<Vec2> at = std::nullopt);

/// An item leaves; the others grow into its room.
Standing deleted(const Standing& wall, std::size_t item, const EditRules& rules = {});

/// A slot's next shot takes over the place and the area of the last.
Standing replaced(const Standing& wall, std::size_t item, const LayoutItem& newcomer,
                  const EditRules& rules = {});

/// One step of a drag: the item's centroid goes to a place as near as pinned items and the canvas allow, the
/// others make way, and those that it has passed go back. One that is dropped is settled().
/// @param to  canvas px
Standing dragged(const Standing& wall, std::size_t item, Vec2 to, const EditRules& rules = {});

/// The item becomes larger or smaller about its place, as near to the wish as is possible.
/// @param factor  of its scale, > 0
Standing resized(const Standing& wall, std::size_t item, double factor, const EditRules& rules = {});

/// The wall on a canvas of another size or ratio.
Standing moved_to(const Standing& wall, Vec2 canvas, const EditRules& rules = {});

/// Where everything is now is its home from here on; what has become small grows again.
Standing settled(const Standing& wall, const EditRules& rules = {});

}  // namespace vitrine::player
