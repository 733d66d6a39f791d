#pragma once

#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/shape.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The result of a descent. Energies are ln E of eq. 3.4.
struct DescentResult {
    std::vector<Vec2> places;  // centroids, canvas px
    std::int64_t steps = 0;    // accepted moves: the paper's iterations
    double first_energy = 0;
    double last_energy = 0;
};

/// Descends the paper's energy (eq. 3.4, paper_energy()): moves single shapes by 1 px in the best of 8
/// directions as long as that lowers the energy. Visits the shapes in random order; a round without a move
/// ends it. Used only for `layout.energy = "paper"`.
/// @param places  centroids, canvas px
/// @param ratio   q_p, width / height of the screen
/// @return        a layout whose energy is not above that of `places`
/// Source: Dynamic Media Assemblage 3.4.2.
DescentResult descend(const ScaledShapes& shapes, std::span<const Vec2> places, double ratio, Random& random,
                      SearchBudget& budget);

}  // namespace vitrine::player
