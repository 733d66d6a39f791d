#pragma once

#include "player/layout/layout.hpp"

#include <span>

namespace vitrine::player {

/// The quantities of eq. 3.4, measured on one arrangement. Lengths in canvas px.
struct Measure {
    double united = 0;  // area of the union of the I-Regions
    double hidden = 0;  // E_occ: sum of the areas minus the union
    Box bounds;         // R_B: the box round all I-Regions
};

/// The measure of an arrangement on a canvas, exact on the grid of player/layout/pack/overlap.hpp.
Measure measured(std::span<const LayoutItem> items, std::span<const Placement> placements);

/// ln E of eq. 3.4: E = E_es^alpha + k E_occ. In logarithms, as E_es^alpha underflows for |q_c - q_p| < 0.03.
/// -infinity where nothing is empty and nothing hidden. For reproduction of the paper only (`layout.energy =
/// "paper"`): without overlaps it depends on the box alone, and it grows the box to hit the ratio.
/// @param ratio  q_p, the wished width / height
/// Source: Dynamic Media Assemblage 3.4.2, eq. 3.4-3.7.
double paper_energy(const Measure& measure, double ratio);

/// The smallest rectangle of a ratio that holds the box: a screen of that ratio shows as much. px^2
double screen_area(const Box& bounds, double ratio);

}  // namespace vitrine::player
