#pragma once

#include "player/layout/plan/plan_request.hpp"
#include "player/scene/frame.hpp"

namespace vitrine::player {

/// The first place of the way back on the wall of an opened folder: a small picture of the wall that it was
/// opened on. At least 15 mm high. Canvas px.
Box back_mark(const Canvas& canvas);

/// The way back as an item of a plan: no I-Region comes under it. It stands in the corner at the bottom left
/// of the canvas, or of the output that is nearest to it, if a new plan has room there; else in another one,
/// which the offset of its placement tells.
/// @param at  its place in a plan that changes a wall
PlanItem back_mark_item(const Canvas& canvas, const Placement& at);

/// Draws the way back above a frame.
/// @param box    its place, canvas px
/// @param outer  of the wall behind
/// @param size   share of its size, as it appears
void draw_back_mark(Frame& frame, const Box& box, const Frame& outer, double size);

}  // namespace vitrine::player
