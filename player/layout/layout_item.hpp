#pragma once

#include "base/state/record.hpp"
#include "player/layout/layout.hpp"

namespace vitrine::player {

/// What a shot brings to the layout: its I-Region inside what every frame shows. A region that is missing or
/// lies outside becomes a box in the middle. A film whose drift leaves no common part counts its whole frame.
LayoutItem layout_item(const MediaRecord& record, const Shot& shot);

}  // namespace vitrine::player
