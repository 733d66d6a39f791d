#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/separation.hpp"

#include <functional>

namespace vitrine::player {

/// Called with every better arrangement; each is free of overlap.
using OnBetter = std::function<void(const Arrangement&)>;

/// Makes all I-Regions as large as possible on the field: the default energy. Goes from one local maximum of
/// the growth to another: exchanges two items or sends one elsewhere, separates what overlaps, compacts by
/// linear programs. Continues also from arrangements that are hardly worse, and after a while from the best.
/// Anytime: the best so far is always free. Has converged, and ends, when 300 trials an item in a row gave
/// nothing better, or 60 that took twice as long as all before.
///
/// @param start   free of overlap
/// @param budget  the most that is spent; few items converge long before
/// @return        at least as large as `start`, free of overlap
/// Source: Dynamic Media Assemblage 3.4.2 asks for a way out of local minima; docs/algorithms.md, (d).
Arrangement densest_arrangement(const PackingProblem& problem, const Arrangement& start, Random& random,
                                SearchBudget& budget, const OnBetter& on_better = {});

/// The same without leaps, for a wall that people look at: items move near their homes only.
/// @param homes  the former places of the items, canvas px
Arrangement calmly_grown(const PackingProblem& problem, const Arrangement& start,
                         const std::vector<Vec2>& homes, Random& random, SearchBudget& budget);

/// The style of separation for a wall that people look at: items stay near their homes.
SeparationStyle calm_style(const std::vector<Vec2>& homes);

/// Moves each item back towards its home as far as the way is free; never farther away from it.
void pull_home(const PackingProblem& problem, Arrangement& arrangement, const std::vector<Vec2>& homes,
               Contacts& contacts);

}  // namespace vitrine::player
