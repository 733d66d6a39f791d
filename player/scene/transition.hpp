#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/edit/motion.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

struct TransitionStyle {
    std::chrono::nanoseconds crossfade = std::chrono::milliseconds(700);
    std::chrono::nanoseconds motion =
        std::chrono::milliseconds(250);  // duration of one stage of a motion; 0: all shots fade instead
    CellStyle cells;
    bool is_even = false;  // shots move at constant speed, for changes that follow a finger
};

/// One part of a transition: `from` moves, or `to` fades in over it.
struct Act {
    std::vector<PlacedShot> from;
    std::vector<PlacedShot> to;
    std::optional<Motion> motion;  // the motion of `from`
    std::chrono::nanoseconds duration{0};
    bool is_even = false;  // true: moves at constant speed; false: moves start and end slowly
};

/// The acts that lead from one wall to the next. First the shots that leave without a successor fade out.
/// Then the shots that stay move to their new places, so that no I-Region is covered at any moment. Then the
/// new shots fade in. A slot's last shot makes room for those that move, and stays until its next one has
/// faded in. If nothing moves, or no such motion is found, there is one crossfade.
/// @param shown, incoming  both on this canvas, with cells
std::vector<Act> transition(Vec2 canvas, std::span<const PlacedShot> shown,
                            std::span<const PlacedShot> incoming, const TransitionStyle& style);

std::chrono::nanoseconds duration_of(std::span<const Act> acts);

/// The acts of one transition and the time since the first act's start.
struct TransitionTime {
    std::span<const Act> acts;  // at least one
    std::chrono::nanoseconds passed{0};
};

/// The frame of a transition at this time.
Frame transition_frame(Vec2 canvas, const TransitionTime& time, const CellStyle& style,
                       std::chrono::nanoseconds now);

}  // namespace vitrine::player
