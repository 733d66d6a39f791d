#include "player/layout/edit/edit_window.hpp"

#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/flat_plan.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr std::size_t large_wall = 40;  // items, from which edits are local
constexpr double window_items = 14;     // about as many are in a window
constexpr double at_the_edge = 0.01;    // canvas px beyond a window that count as in it

/// The part of a request that lies in a window, in the window's coordinates. @param inside  out: its items
PlanRequest windowed(const PlanRequest& request, const Box& window, std::vector<std::size_t>& inside) {
    const Box field{window.min - Vec2{request.margin, request.margin},
                    window.max + Vec2{request.margin, request.margin}};
    PlanRequest part = request;
    part.canvas = canvas_within(request.canvas, field);
    part.items.clear();
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        PlanItem item = request.items[i];
        if (item.previous) {
            const Box box = box_of(item.item, *item.previous);
            if (intersection(box, field).is_empty()) continue;
            item.is_pinned = item.is_pinned || !is_box_within(box, window, at_the_edge);
            item.previous->offset = item.previous->offset - field.min;
            if (item.home) item.home->offset = item.home->offset - field.min;
        }
        if (item.seat) item.seat->centre = item.seat->centre - field.min;
        inside.push_back(i);
        part.items.push_back(std::move(item));
    }
    return part;
}

}  // namespace

bool is_box_within(const Box& inner, const Box& outer, double tolerance) {
    return inner.min.x >= outer.min.x - tolerance && inner.min.y >= outer.min.y - tolerance &&
           inner.max.x <= outer.max.x + tolerance && inner.max.y <= outer.max.y + tolerance;
}

Box box_of(const LayoutItem& item, const Placement& at) {
    const Shape shape = shape_of(item.region);
    const Vec2 place = shape.centroid * at.scale + at.offset;
    return {shape.extent.min * at.scale + place, shape.extent.max * at.scale + place};
}

Placement moved_inside(const LayoutItem& item, Placement at, Vec2 canvas, double margin) {
    const Box box = box_of(item, at);
    const Vec2 low{std::max(0.0, margin - box.min.x), std::max(0.0, margin - box.min.y)};
    const Vec2 high{std::max(0.0, box.max.x + margin - canvas.x),
                    std::max(0.0, box.max.y + margin - canvas.y)};
    at.offset = at.offset + low - high;
    return at;
}

Box window_at(const WallState& wall, Vec2 place, const EditRules& rules) {
    const double edge = std::min(rules.margin, std::min(wall.canvas.x, wall.canvas.y) / 4);
    const Box field{{edge, edge}, wall.canvas - Vec2{edge, edge}};
    if (wall.items.size() <= large_wall) return field;
    const double share = std::sqrt(window_items / static_cast<double>(wall.items.size()));
    const Vec2 half = wall.canvas * (share / 2);
    const Vec2 middle{std::clamp(place.x, field.min.x + half.x, field.max.x - half.x),
                      std::clamp(place.y, field.min.y + half.y, field.max.y - half.y)};
    return intersection(field, {middle - half, middle + half});
}

std::optional<Layout> planned_in(const Box& window, const PlanRequest& request, const PlanWatch& watch) {
    std::vector<std::size_t> inside;
    const PlanRequest part = windowed(request, window, inside);
    const std::optional<Layout> found = plan_change(part, watch);
    if (!found) return std::nullopt;
    Layout layout{.canvas = request.canvas, .placements = std::vector<Placement>(request.items.size())};
    for (std::size_t i = 0; i < request.items.size(); ++i)
        layout.placements[i] = request.items[i].previous.value_or(Placement{});
    const Vec2 origin = window.min - Vec2{request.margin, request.margin};
    for (std::size_t k = 0; k < inside.size(); ++k) {
        Placement at = found->placements[k];
        at.offset = at.offset + origin;
        if (!part.items[k].is_pinned) layout.placements[inside[k]] = at;
    }
    return layout;
}

}  // namespace vitrine::player
