#pragma once

#include "player/layout/cells/grid.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// Stands for what lies beyond the canvas' edge.
inline constexpr std::size_t no_owner = std::numeric_limits<std::size_t>::max();

/// The border between two areas, from one junction to the next. A junction is a point where three areas meet,
/// or two and the canvas' edge. A border without a junction is closed: its first point is its last one.
struct Seam {
    std::size_t left = no_owner;  // owner of the area on the positive-angle side
    std::size_t right = no_owner;
    Loop line;  // open; at least two points
};

/// Takes areas apart into the seams between them. None: the areas do not cover the canvas without gap and
/// overlap. Points that are some grid steps apart become one.
std::optional<std::vector<Seam>> seams_of(std::vector<Loops> areas, const Box& canvas);

/// Puts the areas together again. Outer loops run counter-clockwise, holes clockwise.
/// @param owners  number of areas; each seam's owners are less than that, or no_owner
std::vector<Loops> areas_of(std::span<const Seam> seams, std::size_t owners);

/// The corners of a seam without its ends and without points on straight stretches.
std::size_t bends_of(const Seam& seam);

}  // namespace vitrine::player
