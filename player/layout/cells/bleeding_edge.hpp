#pragma once

#include "player/layout/layout.hpp"

namespace vitrine::player {

/// The item without the edge of its core into which the picture outside bleeds: a bar or the border of a
/// scan. Samplers mix neighbouring pixels, most of all in smaller copies. The I-Region stays whole.
/// @param picture  size of the upright picture, source px
LayoutItem without_bleeding_edge(LayoutItem item, Vec2 picture, const Placement& at);

}  // namespace vitrine::player
