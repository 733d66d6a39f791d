#pragma once

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/search_budget.hpp"

#include <functional>
#include <span>

namespace vitrine::player {

/// The share of the canvas without a frame, in [0, 1], sampled at 64 x 36 points.
/// @param frames  one for each item, source px from the centroid of its region
double unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                      const Arrangement& arrangement);

/// The same for few items, exact.
double exact_unfilled_share(const PackingProblem& problem, std::span<const Box> frames,
                            const Arrangement& arrangement);

/// More pictures fill the canvas by themselves.
constexpr std::size_t max_filled = 48;

/// The most annealings from one start.
constexpr std::size_t max_annealings = 3;

/// The aims of a filling.
struct FillingTargets {
    std::vector<Box> frames;      // see unfilled_share(); none: pictures need not fill the canvas
    std::vector<double> natural;  // the items' scales by their weights, up to a common factor
    std::vector<Vec2> homes;      // canvas px; items should stay near them; none: they may go anywhere
    double emptiness = 3;         // costs of an area without pixels, as a multiple of one without I-Regions
    double fair_size = -0.15;     // ln(scale) relative to the natural one; a smaller item is tiny
    int tries = 60'000;           // of each annealing
    double heating = 1;           // factor of the temperature from one annealing to the next
    double trade_share = 0;       // of the tries, two items or more: one item grows and another one shrinks
    double max_way = 0.05;        // of one move where items have homes, share of the field's diagonal
    /// True if the items have a way from where they are to there; no function: to everywhere.
    std::function<bool(const PackingProblem&, const Arrangement&)> is_reachable;
};

/// The mean distance of the items from home, as a share of the field's diagonal; 0: they have none.
double mean_way(const PackingProblem& problem, const FillingTargets& targets, std::span<const Vec2> places);

/// Up to so many items the filling knows exactly what no frame reaches.
constexpr std::size_t max_exact = 5;

/// Moves and resizes single items, so that I-Regions cover more of the canvas and frames fill it: an area
/// without pixels costs `emptiness` times as much as one without I-Regions. Differences in size and distances
/// from home cost, too. Simulated annealing; every state is free of overlap.
/// @param problem  in: the problem of `start`; out: with the scales of the result
/// @param start    free of overlap
/// @return         free of overlap, at no higher cost
Arrangement fill_gaps(PackingProblem& problem, const FillingTargets& targets, const Arrangement& start,
                      Random& random, SearchBudget& budget);

}  // namespace vitrine::player
