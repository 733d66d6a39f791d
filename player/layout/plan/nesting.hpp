#pragma once

#include "player/layout/plan/plan_request.hpp"

namespace vitrine::player {

/// Lays out items of which some form groups, such as the shots that stand for one folder. Each group is one
/// body on the canvas beside the items without a group, and its own assemblage inside that body. So the hulls
/// of two groups never overlap.
///
/// A group all of whose items are placed already is a body of the shape of their hull: it moves as a whole,
/// as little as other placed items do, and its items keep their places in it. Another group is a box. Boxes
/// grow into the room between the bodies, and the group's items are packed on the box. Items that are placed
/// stay where they are in it. Bodies keep clear of the bands of the canvas, unless a group is alone on it.
///
/// The layout lists the groups with more than one item.
/// Source: Dynamic Media Assemblage, chapter 4, the media file browser (fig. 4.6), and future work
/// (hierarchies of media). The bodies are ours.
Layout plan_nested(const PlanRequest& request, const PlanWatch& watch = {});

}  // namespace vitrine::player
