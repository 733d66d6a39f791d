#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/plan/motion.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

struct TransitionStyle {
    std::chrono::nanoseconds duration = std::chrono::milliseconds(800);  // of the whole transition
    CellStyle cells;
    bool moves = true;  // false: all shots that change fade
};

/// A shot of the old or of the new wall, and its part in a transition.
struct ChangingShot {
    PlacedShot placed;                  // on its own wall, with its cell there
    std::optional<std::size_t> moving;  // its place in the motion; none: it leaves, or it comes
    Vec2
        focus;  // canvas px; its cell shrinks to this point while it leaves, and grows from it while it comes
};

/// The way from one wall to the next: who leaves, comes and moves, from where to where, when and how. A
/// value; transition_frame() draws it at any time.
///
/// All happens at once. The shots that stay move, so that no I-Region of theirs is ever covered. A shot that
/// leaves keeps what the others leave of its cell, and a shot that comes fades in over it.
struct Transition {
    Vec2 canvas;  // px
    std::vector<ChangingShot> old_wall;
    std::vector<ChangingShot> new_wall;
    Motion motion;          // of the shots that stay
    double fade_begin = 0;  // share of the duration: from here on the new wall fades in
    double fade_end = 1;    // share of the duration: from here on the new wall is opaque
    std::chrono::nanoseconds duration{0};
};

/// Finds the transition from one wall to the next. A shot that stays but has no free way to its new place
/// leaves its old place and comes to its new one; only such shots do so.
/// @param shown, incoming  both on this canvas, with cells
Transition transition(Vec2 canvas, std::span<const PlacedShot> shown, std::span<const PlacedShot> incoming,
                      const TransitionStyle& style);

/// The number of shots that stay but have no free way: they fade from place to place.
std::size_t wayless_count(const Transition& transition);

/// The placements of the motion. @param share  of the duration
std::vector<Placement> placements_at(const Transition& transition, double share);

/// The share to which the region of a shot that leaves or comes must shrink towards its focus, so that it
/// touches none of the shots that move. 0: it has no place at all.
/// @param placements  of the motion
double free_share(const Transition& transition, const ChangingShot& shot,
                  std::span<const Placement> placements);

/// A region that is shrunk to a smaller share has no cell any more.
constexpr double min_free_share = 0.03;

}  // namespace vitrine::player
