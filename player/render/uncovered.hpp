#pragma once

#include "base/geometry/box.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The part of an area that boxes leave free, cut into boxes that do not overlap. Empty boxes are left out.
std::vector<Box> uncovered(const Box& area, std::span<const Box> boxes);

}  // namespace vitrine::player
