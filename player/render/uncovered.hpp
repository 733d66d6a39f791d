#pragma once

#include "base/geometry/box.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// What boxes leave of an area, cut into boxes that do not overlap. Empty ones count nothing.
std::vector<Box> uncovered(const Box& area, std::span<const Box> boxes);

}  // namespace vitrine::player
