#pragma once

#include "player/layout/pack/filling.hpp"

#include <cstddef>
#include <vector>

namespace vitrine::player {

/// An arrangement with the scale of each item, canvas px per source px.
struct SizedArrangement {
    std::vector<Vec2> places;  // centroids, canvas px
    std::vector<double> scales;
};

/// Costs of a way from home as long as the field's diagonal, for all items on average. A layout that moves
/// all by a tenth of it must leave this much less of the canvas without pixels: a tenth of it / `emptiness`.
constexpr double way_weight = 1;

/// The most items for which best_rectangles() is fast: the work triples with each further one.
constexpr std::size_t max_in_rectangles = 5;

/// Divides the field into one rectangle for each item, by cuts from side to side, and puts each item into its
/// own: as large as its region fits, its frame reaching as far as it can. Looks at every division whose cuts
/// lie on a grid of 48 x 48; up to four rectangles can stand in no other way. Costs as in fill_gaps(), but a
/// frame counts in its own rectangle only, and a region as the box around it.
///
/// @param count  the most results
/// @return       free of overlap. First the best one of each of the best first cuts, the best cut first: its
///               parts are exchanged so that frames fill most of the canvas and items are near home. Then the
///               second best of each, and so on
std::vector<SizedArrangement> best_rectangles(const PackingProblem& problem, const FillingTargets& targets,
                                              std::size_t count);

}  // namespace vitrine::player
