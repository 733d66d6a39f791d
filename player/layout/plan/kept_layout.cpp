#include "player/layout/plan/kept_layout.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/pack/overlap.hpp"
#include "player/layout/plan/bands.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr double rounding = 0.01;  // canvas px, or px^2: of places that were scaled to another canvas

bool is_within(const Canvas& canvas, const Box& box) {
    return box.min.x >= -rounding && box.min.y >= -rounding && box.max.x <= canvas.x + rounding &&
           box.max.y <= canvas.y + rounding;
}

bool are_apart(const std::vector<Polygon>& regions) {
    std::vector<GridPolygon> all;
    all.reserve(regions.size());
    for (const Polygon& region : regions)
        all.push_back(snapped(region));
    return UnionArea(std::move(all)).overlap() <= rounding;
}

/// The I-Regions of the items at their places, and the hulls of their groups.
struct PlacedRegions {
    std::vector<Polygon> regions;
    std::vector<Polygon> bodies;
    std::vector<LayoutGroup> groups;
};

PlacedRegions regions_of(const PlanRequest& request) {
    PlacedRegions placed;
    std::map<int, LayoutGroup> groups;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const PlanItem& item = request.items[i];
        placed.regions.push_back(placed_region(item.item, *item.previous));
        if (item.group == PlanItem::no_group)
            placed.bodies.push_back(placed.regions.back());
        else
            groups[item.group].items.push_back(i);
    }
    for (auto& [number, group] : groups) {
        Polygon points;
        for (const std::size_t i : group.items)
            points.insert(points.end(), placed.regions[i].begin(), placed.regions[i].end());
        placed.bodies.push_back(convex_hull(points));
        if (group.items.size() > 1) placed.groups.push_back(std::move(group));
    }
    return placed;
}

}  // namespace

std::optional<Layout> kept_layout(const PlanRequest& request) {
    const auto is_placed = [&](const PlanItem& item) {
        return item.previous &&
               is_within(request.canvas, bounding_box(placed_region(item.item, *item.previous)));
    };
    if (!request.keeps_places || request.items.empty() || !std::ranges::all_of(request.items, is_placed))
        return std::nullopt;
    PlacedRegions placed = regions_of(request);
    if (!are_apart(placed.regions) || !are_apart(placed.bodies)) return std::nullopt;
    Layout layout{.canvas = request.canvas, .groups = std::move(placed.groups), .energy = 1};
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        layout.placements.push_back(*request.items[i].previous);
        layout.energy -= std::abs(signed_area(placed.regions[i])) / (request.canvas.x * request.canvas.y);
    }
    return is_clear_of_bands(request, layout.placements) ? std::optional(std::move(layout)) : std::nullopt;
}

}  // namespace vitrine::player
