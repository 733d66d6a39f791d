#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"

namespace vitrine::player {

/// Moves all items at once so that they can grow as far as small moves allow: a local maximum of the growth.
/// For each pair the best separating side stays between the two; so all constraints are linear in places and
/// growth. A linear program is solved and the sides are chosen again, until nothing is gained.
///
/// @param start  free of overlap
/// @return       at least as large as `start`, free of overlap
/// Source: compaction by linear programs, Li & Milenkovic 1995; here with growth instead of the length of a
/// strip of cloth.
Arrangement compacted(const PackingProblem& problem, const Arrangement& start, Contacts& contacts,
                      SearchBudget& budget);

}  // namespace vitrine::player
