#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/vec2.hpp"

#include <optional>

namespace vitrine::player {

/// The turn of a panel, clockwise from upright, as seen from the front.
enum class Rotation { none, right, half, left };

/// @param degrees  0, 90, 180 or 270, clockwise
inline Rotation rotation_of(int degrees) {
    return static_cast<Rotation>(degrees / 90 % 4);
}

/// The turn in degrees, clockwise: 0, 90, 180 or 270.
inline int degrees_of(Rotation rotation) {
    return static_cast<int>(rotation) * 90;
}

/// The place of the canvas on the pixels of a screen.
struct View {
    Rotation rotation = Rotation::none;
    int left = 0;  // px of the screen (not of the turned canvas) that stay black
    int top = 0;
    int right = 0;
    int bottom = 0;
    std::optional<Box> part;  // canvas px, what the screen shows of the canvas; none: all of it

    bool operator==(const View&) const = default;
};

/// The canvas that fills a screen of width x height px within the margins, in the same shape.
/// @pre the margins leave at least one pixel
Vec2 canvas_size(int width, int height, const View& view);

/// The part of a canvas that a view shows, canvas px.
inline Box seen_part(const View& view, Vec2 canvas) {
    return view.part.value_or(Box{{0, 0}, canvas});
}

/// The view with further margins for a canvas, or a part of it, of another shape: as large as there is room,
/// in the middle.
View letterboxed(int width, int height, View view, Vec2 canvas);

/// The canvas point that is shown at a place of a screen. @param share  the place as shares of the screen's
/// pixels; the result lies within what the screen shows of the canvas
Vec2 canvas_point(int width, int height, const View& view, Vec2 canvas, Vec2 share);

/// Maps canvas points in [0, size] to GL's [-1, 1] square: ndc = x_axis * x + y_axis * y + origin.
struct ToNdc {
    Vec2 x_axis;
    Vec2 y_axis;
    Vec2 origin;
};

/// Maps a canvas of `size` onto the whole square. On a panel that is turned to the right, the canvas' right
/// side is at the top of the pixels, so that viewers see it upright.
inline ToNdc to_ndc(Vec2 size, Rotation rotation) {
    const double sx = 2 / size.x;
    const double sy = 2 / size.y;
    switch (rotation) {
    case Rotation::none:
        return {{sx, 0}, {0, -sy}, {-1, 1}};
    case Rotation::right:
        return {{0, sx}, {sy, 0}, {-1, -1}};
    case Rotation::half:
        return {{-sx, 0}, {0, sy}, {1, -1}};
    case Rotation::left:
        return {{0, -sx}, {-sy, 0}, {1, 1}};
    }
    return {};
}

/// The same map with another canvas point at the top left.
inline ToNdc seen_from(ToNdc view, Vec2 point) {
    view.origin = view.origin - view.x_axis * point.x - view.y_axis * point.y;
    return view;
}

}  // namespace vitrine::player
