#pragma once

#include "player/layout/layout.hpp"

#include <span>

namespace vitrine {

/// What an energy is made of, measured on one arrangement. Lengths in canvas px.
struct Measure {
    double united = 0;  // area of the union of the I-Regions
    double hidden = 0;  // E_occ: sum of the areas minus the union
    Box bounds;         // R_B: the box round all I-Regions
};

/// Of an arrangement on a canvas, exact on the grid of base/geometry/overlap.hpp.
Measure measured(std::span<const LayoutItem> items, std::span<const Placement> placements);

/// ln E of eq. 3.4: E = E_es^alpha + k E_occ. In logarithms, as E_es^alpha underflows for |q_c - q_p| < 0.03.
/// -infinity where nothing is empty and nothing hidden. For reproduction of the paper only: without
/// overlaps it depends on the box alone, and it grows the box to hit the ratio.
/// @param ratio  q_p, the wished width / height
/// Source: Dynamic Media Assemblage 3.4.2, eq. 3.4-3.7.
double paper_energy(const Measure& measure, double ratio);

/// The smallest rectangle of a ratio that holds the box: what a screen of that ratio shows. px^2
double screen_area(const Box& bounds, double ratio);

/// The energy that is minimised: compared part by part, the first that differs by more than `tolerance`
/// decides. No part is ever bought by a later one.
struct ScreenEnergy {
    double hidden = 0;  // E_occ / sum of areas
    double empty = 1;   // E*: 1 - union / screen_area
    double spread = 0;  // sum A_i (dx^2 / q + q dy^2) about the centre, over the sum of areas squared
    double moved = 0;   // sum A_i |p_i - p_i before|^2, over the same

    static constexpr double tolerance = 1e-9;

    friend bool operator<(const ScreenEnergy& a, const ScreenEnergy& b);
};

}  // namespace vitrine
