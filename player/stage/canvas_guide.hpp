#pragma once

#include "base/geometry/box.hpp"
#include "player/words/word_item.hpp"

#include <memory>
#include <string>

namespace vitrine::player {

/// The facts of one screen that a guide for placing screens draws.
struct GuideView {
    std::string name;  // of the output; BOX/OUTPUT on a wall of several boxes
    Vec2 size;         // px of the picture, as the screen hangs
    Box part;          // canvas px, what the screen shows
    Vec2 canvas;       // px
    double unit = 1;   // canvas px a unit of the rulers
    Vec2 origin;       // units at the canvas' top left corner

    bool operator==(const GuideView&) const = default;
};

/// The guide for one screen, of its size: rulers along its edges, the name of its output and its place, and
/// the diagonals of the whole canvas. Behind a bezel nothing is drawn: lines go on where they would be.
std::shared_ptr<const WordPicture> canvas_guide(const GuideView& view);

}  // namespace vitrine::player
