#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/separation.hpp"

#include <functional>

namespace vitrine::player {

/// Called for every better arrangement. Each is free of overlap.
using OnBetter = std::function<void(const Arrangement&)>;

/// Makes all I-Regions as large as possible on the field: the default energy. Goes from one local maximum of
/// the growth to another: exchanges two items or moves one anywhere, separates overlapping items, compacts by
/// linear programs. Also continues from arrangements that are slightly worse, and after a while from the best
/// one. Can be stopped at any time: the best arrangement so far is always free. Has converged, and ends,
/// after 300 trials per item in a row without a gain, or after 60 trials per item that took twice as long as
/// all trials before.
///
/// @param start   free of overlap
/// @param budget  limit of the search; few items converge long before
/// @return        at least as large as `start`, free of overlap
/// Source: Dynamic Media Assemblage 3.4.2 asks for a way out of local minima; docs/algorithms.md, (d).
Arrangement densest_arrangement(const PackingProblem& problem, const Arrangement& start, Random& random,
                                SearchBudget& budget, const OnBetter& on_better = {});

/// The same without leaps, for a wall that people look at: items only move near their homes.
/// @param homes  the former places of the items, canvas px
Arrangement calmly_grown(const PackingProblem& problem, const Arrangement& start,
                         const std::vector<Vec2>& homes, Random& random, SearchBudget& budget);

/// The style of separation for a wall that people look at: items stay near their homes.
SeparationStyle calm_style(const std::vector<Vec2>& homes);

/// Moves each item back towards its home, as far as the way is free. Moves none away from it.
void pull_home(const PackingProblem& problem, Arrangement& arrangement, const std::vector<Vec2>& homes,
               Contacts& contacts);

}  // namespace vitrine::player
