#pragma once

#include "player/layout/edit/wall_state.hpp"

#include <cstddef>
#include <span>

namespace vitrine::player {

/// A place that a visitor gives an item: under a finger, larger where it is, or where it was let go.
struct Wish {
    std::size_t item = 0;
    Placement at;
    bool is_in_hand = false;  // it passes: it may cross a band of the canvas
    bool is_let_go = false;   // it may move and grow to its former size from there, and stays then
};

/// The wall after wishes. Every item without a wish stands at its home, or as near as the wishes allow: none
/// moves farther from home than a quarter of the canvas' diagonal. So the places depend on the homes and the
/// wishes only, and an item returns exactly once nothing is in its place. A wish that cannot be given room
/// becomes smaller; one that is on another is not heard.
///
/// An item that was let go, and all others, keep the places that they get: their homes. If a fifth of the
/// canvas would be left without a picture, others move farther then: up to two fifths of the diagonal. On a
/// wall of up to eight items they do so for a fortieth, and to any place to which all have a way.
/// @param wishes  at most one for each item; the first ones go before
WallState made_way(const WallState& wall, std::span<const Wish> wishes, const EditRules& rules);

}  // namespace vitrine::player
