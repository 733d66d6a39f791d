#include "player/render/view.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

bool is_upright(Rotation rotation) {
    return rotation == Rotation::none || rotation == Rotation::half;
}

Vec2 turned(Vec2 size, Rotation rotation) {
    return is_upright(rotation) ? size : Vec2{size.y, size.x};
}

}  // namespace

Vec2 canvas_size(int width, int height, const View& view) {
    return turned({static_cast<double>(width - view.left - view.right),
                   static_cast<double>(height - view.top - view.bottom)},
                  view.rotation);
}

View letterboxed(int width, int height, View view, Vec2 canvas) {
    const Vec2 room = turned(canvas_size(width, height, view), view.rotation);
    const Box part = seen_part(view, canvas);
    const Vec2 wanted = turned(part.max - part.min, view.rotation);
    const double scale = std::min(room.x / wanted.x, room.y / wanted.y);
    const int across = static_cast<int>(room.x - std::round(wanted.x * scale));
    const int down = static_cast<int>(room.y - std::round(wanted.y * scale));
    view.left += across / 2;
    view.right += across - across / 2;
    view.top += down / 2;
    view.bottom += down - down / 2;
    return view;
}

Vec2 canvas_point(int width, int height, const View& view, Vec2 canvas, Vec2 share) {
    const Vec2 room{static_cast<double>(width - view.left - view.right),
                    static_cast<double>(height - view.top - view.bottom)};
    const double x = std::clamp((share.x * width - view.left) / room.x, 0.0, 1.0);
    const double y = std::clamp((share.y * height - view.top) / room.y, 0.0, 1.0);
    const Box part = seen_part(view, canvas);
    const Vec2 size = part.max - part.min;
    switch (view.rotation) {
    case Rotation::none:
        break;
    case Rotation::right:  // the canvas' right side is at the top of the panel's pixels
        return part.min + Vec2{size.x * (1 - y), size.y * x};
    case Rotation::half:
        return part.min + Vec2{size.x * (1 - x), size.y * (1 - y)};
    case Rotation::left:
        return part.min + Vec2{size.x * y, size.y * (1 - x)};
    }
    return part.min + Vec2{size.x * x, size.y * y};
}

}  // namespace vitrine::player
