#pragma once

#include "analyzer/saliency/flow_field.hpp"
#include "base/geometry/vec2.hpp"

#include <span>

namespace vitrine::analyzer {

/// The motion that most vectors agree on, voted in magnitude and direction, as the median around the winning
/// bin. {0, 0} where there are no vectors.
///
/// @param weights  one a vector: weight of its vote; empty: all the same
/// Source: Dynamic Media Assemblage 3.2. Differs: a vote counts for the neighbouring bins too, and all motion
/// below a quarter pixel is one bin, for its direction is noise.
Vec2 voted_motion(std::span<const Vec2> vectors, std::span<const double> weights = {});

/// Motion of the background at a place: pan + turn * (place - centre), the product of complex numbers.
struct BackgroundMotion {
    Vec2 pan;
    Vec2 turn;
    Vec2 centre;

    Vec2 at(Vec2 place) const {
        const Vec2 p = place - centre;
        return pan + Vec2{turn.x * p.x - turn.y * p.y, turn.x * p.y + turn.y * p.x};
    }
};

/// Pan, zoom and roll that most of the reliable vectors follow, by iterated least squares that begin at
/// `pan`.
BackgroundMotion fitted_background(const FlowField& flow, Vec2 pan);

}  // namespace vitrine::analyzer
