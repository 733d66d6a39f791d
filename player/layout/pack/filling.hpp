#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <span>

namespace vitrine::player {

/// The share of the canvas without a frame, in [0, 1], sampled at 64 x 36 points.
/// @param frames  one for each item, source px from the centroid of its region
double unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                      const Arrangement& arrangement);

/// The aims of a filling.
struct FillingTargets {
    std::vector<Box> frames;      // see unfilled_share(); none: pictures need not fill the canvas
    std::vector<double> natural;  // the items' scales by their weights, up to a common factor
    std::vector<Vec2> homes;      // canvas px; items should stay near them; none: they may go anywhere
};

/// Moves and resizes single items, so that I-Regions cover more of the canvas and frames fill it: an area
/// without pixels costs three times as much as one without I-Regions. Differences in size and distances from
/// home cost, too. Simulated annealing; every state is free of overlap.
/// @param problem  in: the problem of `start`; out: with the scales of the result
/// @param start    free of overlap
/// @return         free of overlap, at no higher cost
Arrangement fill_gaps(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                      Random& random, SearchBudget& budget);

}  // namespace vitrine::player
