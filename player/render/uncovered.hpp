#pragma once

#include "base/geometry/box.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The part of an area that the boxes leave free, cut into boxes without overlap. Empty boxes are left out.
std::vector<Box> uncovered(const Box& area, std::span<const Box> boxes);

}  // namespace vitrine::player
