#pragma once

#include "player/layout/pack/contacts.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The order in which items are packed.
enum class PackingOrder { as_given, largest_first };

/// Packs all shapes round the origin: the first item stands there, each other one at the first gap along
/// one of 64 rays from there (then refined), on the ray that needs the smallest screen of the wished ratio.
/// @param shapes    their scales are set in `contacts`
/// @param ratio     q_p, width / height of the screen
/// @return          centroids in px about the first, free of overlap
/// Source: Dynamic Media Assemblage 3.4.1. Differs: exact gaps, which also fill holes.
std::vector<Vec2> initial_packing(const ScaledShapes& shapes, const Contacts& contacts, double ratio,
                                  PackingOrder order);

}  // namespace vitrine::player
