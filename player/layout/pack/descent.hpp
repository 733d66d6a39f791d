#pragma once

#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/shape.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// What a descent came to. Energies are ln E of eq. 3.4.
struct Descended {
    std::vector<Vec2> places;  // centroids, canvas px
    std::int64_t steps = 0;    // accepted: the paper's iterations
    double first_energy = 0;
    double last_energy = 0;
};

/// Moves single shapes by 1 px in the best of 8 directions as long as that lowers the energy; the shapes
/// are visited in random order, and a round without any move ends it.
/// @param scales  canvas px per source px
/// @param places  centroids, canvas px
/// @param ratio   q_p, width / height of the screen
/// @return        a layout whose energy is not above that of `places`
/// Source: Dynamic Media Assemblage 3.4.2.
Descended descended(std::span<const Shape> shapes, std::span<const double> scales,
                    std::span<const Vec2> places, double ratio, Random& random, Effort& effort);

}  // namespace vitrine::player
