#pragma once

#include "player/layout/edit/motion.hpp"
#include "player/scene/crossfade.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// How a wall becomes another.
struct TransitionStyle {
    std::chrono::nanoseconds crossfade = std::chrono::milliseconds(700);
    std::chrono::nanoseconds motion =
        std::chrono::milliseconds(250);  // of one stage; 0: nothing moves, all fades
    CellStyle cells;
    bool is_even = false;  // moves at one speed, as what follows a finger does
};

/// A part of a transition: `from` moves, or `to` fades in over it.
struct Act {
    std::vector<PlacedShot> from;
    std::vector<PlacedShot> to;
    std::optional<Motion> motion;  // of `from`
    std::chrono::nanoseconds duration{0};
    bool is_even = false;  // else moves begin and end slowly
};

/// Gives each shot its cell of a layout of these shots alone.
void give_cells(std::vector<PlacedShot>& wall, Vec2 canvas, const CellStyle& style);

/// From one wall to the next: what leaves without a successor fades out, then what stays moves to its new
/// place so that no region is covered at any moment, then what is new fades in; a slot's last shot gives room
/// to what moves and stays until its next one has faded in. Where nothing moves, or there is no way: one
/// crossfade.
/// @param shown, incoming  both on this canvas, with cells
std::vector<Act> transition(Vec2 canvas, std::span<const PlacedShot> shown,
                            std::span<const PlacedShot> incoming, const TransitionStyle& style);

std::chrono::nanoseconds duration_of(std::span<const Act> acts);

/// The picture at a time since the first act began. @pre there are acts
Frame picture_of(std::span<const Act> acts, std::chrono::nanoseconds passed, Vec2 canvas,
                 const CellStyle& style, std::chrono::nanoseconds now);

}  // namespace vitrine::player
