#pragma once

#include "player/layout/cells/seam_field.hpp"

#include <cstddef>
#include <vector>

namespace vitrine::player {

/// Makes one bend of two that are nearly one, on the side where no region is.
void join_bends(SeamField& field, std::size_t k);

/// Rounds the bends of the seams that may move, with less than the radius where it would cut a region or
/// reach the next bend. @param radius  canvas px
void round_bends(std::vector<Seam>& seams, const SeamLimits& limits, double radius);

}  // namespace vitrine::player
