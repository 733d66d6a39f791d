#include "player/scene/wall_cells.hpp"

#include "player/layout/cells/cells.hpp"
#include "player/layout/cells/cut_cell.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

/// True if a point lies inside an outline of any shape. Counts the edges to the point's right.
bool is_in(std::span<const Vec2> outline, Vec2 point) {
    bool is_inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i];
        const Vec2 b = outline[(i + 1) % outline.size()];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
}

}  // namespace

void give_cells(std::vector<PlacedShot>& wall, Vec2 canvas, const CellStyle& style) {
    std::vector<LayoutItem> items;
    Layout layout{.canvas = canvas};
    for (const PlacedShot& placed : wall) {
        items.push_back(without_bleeding_edge(placed.shot.item, placed.shot.picture, placed.placement));
        layout.placements.push_back(placed.placement);
    }
    std::map<int, LayoutGroup> groups;
    for (std::size_t i = 0; i < wall.size(); ++i)
        if (wall[i].group != PlanItem::no_group) groups[wall[i].group].items.push_back(i);
    for (auto& [name, group] : groups)
        if (group.items.size() > 1) layout.groups.push_back(std::move(group));
    std::vector<Cell> made = cells(items, layout, style);
    for (std::size_t i = 0; i < wall.size(); ++i)
        wall[i].cell = std::make_shared<const Cell>(std::move(made[i]));
}

double wasted_share(std::span<const PlacedShot> wall, Vec2 canvas) {
    double regions = 0;
    double filler = 0;
    for (const PlacedShot& placed : wall) {
        regions += seat_of(placed.shot.item, placed.placement).area;
        for (const Polygon& polygon : placed.cell->filler)
            filler += signed_area(polygon);
    }
    return 1 + (filler - regions) / (canvas.x * canvas.y);
}

std::vector<PlacedShot> transformed(std::vector<PlacedShot> wall, double scale, Vec2 offset) {
    for (PlacedShot& placed : wall) {
        placed.placement = {placed.placement.scale * scale, placed.placement.offset * scale + offset};
        placed.drift = {placed.drift.from * scale, placed.drift.to * scale};
        placed.cell = std::make_shared<const Cell>(scaled_cell(*placed.cell, scale, offset));
    }
    return wall;
}

Box bounds_of(const Cell& cell) {
    Box bounds;
    bool any = false;
    for (const std::vector<Polygon>* some : {&cell.parts, &cell.filler})
        for (const Polygon& polygon : *some) {
            bounds = any ? united(bounds, bounding_box(polygon)) : bounding_box(polygon);
            any = true;
        }
    return bounds;
}

bool is_at(const PlacedShot& placed, Vec2 point) {
    const auto is_in_one = [&](const std::vector<Polygon>& outlines) {
        return std::ranges::any_of(outlines, [&](const Polygon& outline) { return is_in(outline, point); });
    };
    return placed.cell && (is_in_one(placed.cell->parts) || is_in_one(placed.cell->filler));
}

}  // namespace vitrine::player
