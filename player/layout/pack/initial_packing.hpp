#pragma once

#include "player/layout/pack/contacts.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The order in which items are packed.
enum class PackingOrder { as_given, largest_first };

/// Packs all shapes round the origin: the first item stands there, each other one at the first gap along
/// one of 64 rays from there (then refined), on the ray that needs the smallest screen of the wished ratio.
/// @param scales  canvas px per source px, as set in `contacts`
/// @param ratio   q_p, width / height of the screen
/// @return        centroids in px about the first, free of overlap
/// Source: Dynamic Media Assemblage 3.4.1. Differs: exact gaps, which also fill holes.
std::vector<Vec2> initial_packing(std::span<const Shape> shapes, const Contacts& contacts,
                                  std::span<const double> scales, double ratio, PackingOrder order);

/// Packs all shapes in lines, in their order, so that each is read before the next. The number of lines is
/// the one that needs the smallest screen.
/// @return  centroids in px, free of overlap, without inversions by ReadingOrder
std::vector<Vec2> packed_in_lines(std::span<const Shape> shapes, std::span<const double> scales,
                                  double ratio);

/// The box round all shapes at their places, px.
Box bounds_of(std::span<const Shape> shapes, std::span<const double> scales, std::span<const Vec2> places);

}  // namespace vitrine::player
