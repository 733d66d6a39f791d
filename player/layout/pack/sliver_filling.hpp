#pragma once

#include "player/layout/pack/arrangement.hpp"

#include <span>

namespace vitrine::player {

/// Moves and enlarges single items by a few pixels, so that no sliver stays that no frame reaches: at the
/// canvas' edge and between frames. The samples of a filling do not see slivers.
/// @param problem  in: the problem of `start`; out: with the scales of the result
/// @param frames   one for each item, source px from the centroid of its region
/// @param start    free of overlap
/// @return         free of overlap, with no less of the canvas filled; growth 1
Arrangement slivers_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start);

}  // namespace vitrine::player
