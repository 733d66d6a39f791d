#include "player/scene/folders/back_mark.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/folders/folder_zoom.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double height_share = 0.11;  // of the canvas' shorter side
constexpr double gap_share = 0.02;     // of the canvas' shorter side, to its edges
constexpr double rim_share = 0.04;     // of the mark's height

}  // namespace

Box back_mark(const Canvas& canvas) {
    const Box seen = output_at(canvas, {0, canvas.y});
    const double side = std::min(seen.width(), seen.height());
    const double aspect = canvas.x / canvas.y;
    const double largest = std::min(side / 2, seen.width() / (2 * aspect));
    const double height = std::min(largest, std::max(canvas.finger, side * height_share));
    const double gap = side * gap_share;
    const Vec2 corner{seen.min.x + gap, seen.max.y - gap};
    return {{corner.x, corner.y - height}, {corner.x + height * aspect, corner.y}};
}

PlanItem back_mark_item(const Canvas& canvas, const Placement& at) {
    const Box box = back_mark(canvas);
    const Box seen = output_at(canvas, {0, canvas.y});
    PlanItem item{.item = {.region = to_polygon(box), .core = box}, .previous = at, .is_pinned = true};
    const Vec2 across{seen.min.x + seen.max.x - box.min.x - box.max.x, 0};
    const Vec2 up{0, seen.min.y + seen.max.y - box.min.y - box.max.y};
    item.instead = {up, across, across + up};
    return item;
}

void draw_back_mark(Frame& frame, const Box& box, const Frame& outer, double size) {
    if (size <= 0) return;
    const Vec2 half = (box.max - box.min) * (size / 2);
    const double share = 2 * half.y * (1 - 2 * rim_share) / frame.canvas.y;
    frame.plates.push_back({.box = {box.centre() - half, box.centre() + half}, .below = frame.items.size()});
    for (DrawItem item : placed_frame(outer, {share, box.centre() - outer.canvas * (share / 2)}).items) {
        item.alpha = std::min(item.alpha, max_blended);
        frame.items.push_back(std::move(item));
    }
}

}  // namespace vitrine::player
