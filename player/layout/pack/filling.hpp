#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <span>

namespace vitrine::player {

/// Share of the canvas that lies under no frame, in [0, 1], sampled at 64 x 36 points.
/// @param frames  one an item, source px from the centroid of its region
double unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                      const Arrangement& arrangement);

/// The aims of a filling.
struct FillingTargets {
    std::vector<Box> frames;  // one an item as in unfilled_share(); none: pictures need not fill the canvas
    std::vector<double> natural;  // scales, up to a common factor, that items have by their weights
    std::vector<Vec2> homes;      // canvas px, near which items should stay; none: they may go anywhere
};

/// Moves items and makes them larger or smaller, each by itself, so that I-Regions cover more of the canvas
/// and their frames fill it: a part of it without pixels costs three times as much as one without I-Regions.
/// Sizes that grow apart and distances from home cost too. Simulated annealing, every state free of overlap.
/// @param problem  in: what `start` respects; out: with the scales that were found
/// @param start    free of overlap
/// @return         free of overlap, at no higher cost
Arrangement fill_gaps(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                      Random& random, SearchBudget& budget);

}  // namespace vitrine::player
