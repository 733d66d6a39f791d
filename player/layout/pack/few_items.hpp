#pragma once

#include "player/layout/pack/rectangles.hpp"
#include "player/layout/pack/search_budget.hpp"

namespace vitrine::player {

/// True if few_filled() is made for the problem: two to five items, none pinned, in any order.
bool is_for_few(const PackingProblem& problem);

/// The targets with the costs and the steps by which few items are filled.
FillingTargets targets_for_few(FillingTargets targets);

/// Fills the canvas with few items. It begins with `start` and with the best divisions into rectangles, and
/// fills the gaps of each (filling.hpp), then once more of the best. It takes the one that leaves least of
/// the canvas without pixels, unless an item became tiny or all would go far from home, or one that leaves a
/// little more and that the items can reach from where they are.
/// @param problem  in: the problem of `start`; out: with the scales of the result
/// @param start    free of overlap
/// @return         free of overlap
Arrangement few_filled(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                       Random& random, SearchBudget& budget);

}  // namespace vitrine::player
