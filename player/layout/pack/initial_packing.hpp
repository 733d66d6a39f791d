#pragma once

#include "player/layout/pack/contacts.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The order of packing.
enum class PackingOrder { as_given, largest_first };

/// Packs all shapes around the origin. The first item is placed there. Each further item is placed at the
/// first gap on one of 64 rays from there (then refined): on the ray that needs the smallest screen of the
/// wished ratio.
/// @param shapes    shapes whose scales are set in `contacts`
/// @param ratio     q_p, width / height of the screen
/// @return          centroids in px relative to the first, free of overlap
/// Source: Dynamic Media Assemblage 3.4.1. Differs: exact gaps, which also fill holes.
std::vector<Vec2> initial_packing(const ScaledShapes& shapes, const Contacts& contacts, double ratio,
                                  PackingOrder order);

}  // namespace vitrine::player
