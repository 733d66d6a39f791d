#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <span>

namespace vitrine::player {

/// Share of the canvas that lies under no frame, in [0, 1], sampled at 64 x 64 points.
/// @param frames  of each item, source px from the centroid of its region
double unfilled(const Ground& ground, std::span<const Box> frames, const Arrangement& arrangement);

/// What an arrangement is made better by.
struct FillingWishes {
    std::vector<Box> frames;      // of each item as in unfilled(); none: pictures need not fill the canvas
    std::vector<double> natural;  // scales, up to a common factor, that items have by their weights
    std::vector<Vec2> homes;      // canvas px, that items should stay near; none: they may go anywhere
};

/// Moves items and makes them larger or smaller, each by itself, so that more of the canvas is covered by
/// I-Regions and their frames fill it: a part of it without pixels counts like three without I-Regions.
/// Sizes that grow apart and ways from home count too. Simulated annealing, every state free of overlap.
/// @param ground  in: what `start` respects; out: with the scales that were found
/// @param start   free of overlap
/// @return        free of overlap, not worse in the sum of these
Arrangement filled(Ground& ground, const FillingWishes& wishes, const Arrangement& start, Random& random,
                   Effort& effort);

}  // namespace vitrine::player
