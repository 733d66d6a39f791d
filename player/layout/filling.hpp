#pragma once

#include "player/layout/arrangement.hpp"
#include "player/layout/effort.hpp"

#include <span>

namespace vitrine {

/// Share of the canvas that lies under no frame, in [0, 1], sampled at 64 x 64 points.
/// @param frames  of each item, source px from the centroid of its region
double unfilled(const Ground& ground, std::span<const Box> frames, const Arrangement& arrangement);

/// Moves items, and lets all become a little smaller, so that their frames fill more of the canvas: each
/// per cent of it without pixels counts like a per cent less of I-Regions. Tries random moves and keeps those
/// that do not uncover more.
/// @param start  free of overlap
/// @return       free of overlap, not worse in the sum of both
Arrangement filled(const Ground& ground, std::span<const Box> frames, const Arrangement& start,
                   Random& random, Effort& effort);

}  // namespace vitrine
