#pragma once

#include "base/geometry/vec2.hpp"
#include "base/state/tapestry.hpp"

#include <chrono>

namespace vitrine::player {

/// A tapestry without tiles, for a film whose own is not woven yet: its times are those of the film.
/// @param shape  size of the film's upright picture; only its shape counts
Tapestry unwoven_tapestry(std::chrono::nanoseconds duration, Vec2 shape);

/// True for unwoven_tapestry().
bool is_unwoven(const Tapestry& tapestry);

}  // namespace vitrine::player
