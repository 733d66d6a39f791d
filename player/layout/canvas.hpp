#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/vec2.hpp"
#include "player/layout/layout.hpp"

#include <cstddef>
#include <vector>

namespace vitrine::player {

/// 15 mm at 96 dpi, canvas px: where a panel does not tell its size.
inline constexpr double usual_finger = 57;

/// The px of 15 mm on a panel. @param width, height  px; @param millimetres  its sides as it tells them,
/// which may be 0 or nonsense, such as 16 and 9
double finger_on(int width, int height, Vec2 millimetres);

/// The canvas of a wall: its size in px, and what of it is seen, if several outputs show parts of it.
struct Canvas {
    double x = 0;  // px
    double y = 0;
    std::vector<Box> outputs;  // canvas px, the parts that outputs show; none: all of it is seen
    std::vector<Box> bands;    // canvas px, all that is between and beside the outputs; they may overlap. No
                               // I-Region rests there
    double finger = usual_finger;  // px of 15 mm: the least side of what fingers shall hit
    double unit = 1;               // px of a unit in which outputs are placed (output.canvas)
    Vec2 origin;                   // units, the place of the top left corner

    Canvas() = default;

    /// A canvas that is seen as a whole.
    Canvas(double width, double height) : x(width), y(height) {}

    // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a size is such a canvas
    Canvas(Vec2 size) : x(size.x), y(size.y) {}

    // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a canvas is used as its size
    operator Vec2() const { return {x, y}; }

    /// Compares what layouts depend on: sizes and parts.
    bool operator==(const Canvas& other) const {
        return x == other.x && y == other.y && outputs == other.outputs && bands == other.bands;
    }

    /// Compares the size alone.
    bool operator==(Vec2 size) const { return x == size.x && y == size.y; }
};

/// A canvas of which outputs show these parts. Bands narrower than half a pixel are left out: there the
/// outputs touch.
/// @param outputs  at most some dozen boxes inside the canvas, px
Canvas canvas_of(Vec2 size, std::vector<Box> outputs);

/// The number of surfaces on a canvas: outputs that touch along an edge are one. At least 1.
std::size_t count_surfaces(const Canvas& canvas);

/// The place of one canvas on another. If both have outputs, each output stays where it is; else the canvas
/// is as large as it fits, in the middle.
Placement place_on(const Canvas& canvas, const Canvas& other);

/// The part of a canvas in a box as a canvas of its own.
Canvas canvas_within(const Canvas& canvas, const Box& box);

/// The part that one output shows at a point, or the nearest to it; the whole canvas if it has no outputs.
Box output_at(const Canvas& canvas, Vec2 point);

/// The same, of the output that shows most of a box.
Box output_of(const Canvas& canvas, const Box& box);

}  // namespace vitrine::player
