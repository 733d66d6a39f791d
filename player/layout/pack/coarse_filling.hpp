#pragma once

#include "player/layout/pack/filling.hpp"

namespace vitrine::player {

/// Lets items grow and step aside so that frames fill the canvas, each by one of a few steps from where it
/// is, and only if that fills clearly more. So items do not tremble between the plans of a drag, which differ
/// little. Nothing is random.
/// @param problem  in: the problem of `start`; out: with the scales of the result
/// @param frames   see unfilled_share()
/// @param start    free of overlap
/// @return         free of overlap; no item is smaller than before
Arrangement coarsely_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start);

}  // namespace vitrine::player
