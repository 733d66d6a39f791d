#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"

#include <span>

namespace vitrine::player {

/// True if a box and a convex polygon are at least `clearance` apart. Canvas px.
bool is_clear_of(const Box& box, const Polygon& polygon, double clearance);

/// Lets a box grow in steps of at most `step` to each side, as far as all its sides stay inside the field and
/// clear of the polygons.
/// @param box  in: clear of them; out: as large as they let it
/// @return     true: it has grown
bool grow_box(Box& box, const Box& field, std::span<const Polygon> others, double clearance, double step);

}  // namespace vitrine::player
