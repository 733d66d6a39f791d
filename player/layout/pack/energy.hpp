#pragma once

#include "player/layout/layout.hpp"

#include <span>

namespace vitrine::player {

/// The quantities of eq. 3.4 for one arrangement. Lengths in canvas px.
struct Measure {
    double united = 0;  // area of the union of the I-Regions
    double hidden = 0;  // E_occ: sum of the areas minus the union
    Box bounds;         // R_B: the box around all I-Regions
};

/// The measure of an arrangement on a canvas, exact on the grid of player/layout/pack/overlap.hpp.
Measure measured(std::span<const LayoutItem> items, std::span<const Placement> placements);

/// ln E of eq. 3.4: E = E_es^alpha + k E_occ. In logarithms, because E_es^alpha underflows for |q_c - q_p| <
/// 0.03. -infinity: nothing is empty and nothing hidden. Only for reproducing the paper (`layout.energy =
/// "paper"`): without overlaps it depends on the box alone, and it enlarges the box to match the ratio.
/// @param ratio  q_p, the wished width / height
/// Source: Dynamic Media Assemblage 3.4.2, eq. 3.4-3.7.
double paper_energy(const Measure& measure, double ratio);

/// The area of the smallest rectangle of a ratio that contains the box, as a screen of that ratio does. px^2
double screen_area(const Box& bounds, double ratio);

}  // namespace vitrine::player
