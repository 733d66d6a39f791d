#include "player/layout/nesting.hpp"

#include "base/geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace vitrine {

namespace {

using Group = std::vector<std::size_t>;

/// The items by group; those without one are groups of one.
std::vector<Group> groups_of(const PlanRequest& request) {
    std::map<int, Group> named;
    std::vector<Group> groups;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        if (request.items[i].group == PlanItem::no_group)
            groups.push_back({i});
        else
            named[request.items[i].group].push_back(i);
    }
    for (auto& [name, group] : named)
        groups.push_back(std::move(group));
    return groups;
}

/// Some items as one, in the coordinates that their placements map to.
LayoutItem as_one(const PlanRequest& request, const Group& group, std::span<const Placement> placements) {
    std::vector<Vec2> corners;
    std::optional<Box> frame;
    double weight = 0;
    for (std::size_t k = 0; k < group.size(); ++k) {
        const LayoutItem& item = request.items[group[k]].item;
        const Placement& at = placements[k];
        const Polygon region = placed_region(item, at);
        corners.insert(corners.end(), region.begin(), region.end());
        const Box core{item.core.min * at.scale + at.offset, item.core.max * at.scale + at.offset};
        frame = frame ? united(*frame, core) : core;
        weight += item.weight;
    }
    return {.region = convex_hull(corners), .core = *frame, .weight = weight};
}

bool stands(const PlanRequest& request, const Group& group) {
    return std::all_of(group.begin(), group.end(), [&](std::size_t i) {
        return request.items[i].previous.has_value() || request.items[i].seat.has_value();
    });
}

/// A group packed by itself: its placements map to a canvas of its own.
struct Packed {
    std::vector<Placement> placements;
    PlanItem item;  // the group as one, in that canvas' px
};

/// Brings placements to where one px is one source px of the item that is enlarged most, so that limits of
/// scale hold for the group as for any item. @return what they were divided by
double to_source_px(std::vector<Placement>& placements) {
    double largest = 0;
    for (const Placement& at : placements)
        largest = std::max(largest, at.scale);
    for (Placement& at : placements)
        at = {at.scale / largest, at.offset * (1 / largest)};
    return largest;
}

/// Packs a group anew, on a canvas of about its share of the whole and of a usual shape.
Packed packed_anew(const PlanRequest& request, const Group& group, const PlanWatch& watch) {
    const double share = static_cast<double>(group.size()) / static_cast<double>(request.items.size());
    const double side = std::sqrt(share * request.canvas.x * request.canvas.y);
    constexpr double shape = 1.15;  // width by height's root
    PlanRequest inner = request;
    inner.canvas = {side * shape, side / shape};
    inner.items.clear();
    for (const std::size_t i : group)
        inner.items.push_back({.item = request.items[i].item});
    Packed packed{.placements = plan(inner, {.should_stop = watch.should_stop}).placements};
    to_source_px(packed.placements);
    packed.item.item = as_one(request, group, packed.placements);
    return packed;
}

/// A group that stands, with its changes made within the box that it takes up; its canvas is the whole one.
Packed packed_again(const PlanRequest& request, const Group& group, const PlanWatch& watch) {
    PlanRequest inner = request;
    inner.items.clear();
    std::vector<Vec2> corners;
    for (const std::size_t i : group) {
        inner.items.push_back(request.items[i]);
        inner.items.back().group = PlanItem::no_group;
        if (!request.items[i].previous) continue;
        const Polygon region = placed_region(request.items[i].item, *request.items[i].previous);
        corners.insert(corners.end(), region.begin(), region.end());
    }
    const Box box = bounding_box(corners);
    const Vec2 margin{request.margin, request.margin};
    const Vec2 origin = box.min - margin;
    inner.canvas = box.max + margin - origin;
    for (PlanItem& item : inner.items) {
        if (item.previous) item.previous->offset = item.previous->offset - origin;
        if (item.seat) item.seat->centre = item.seat->centre - origin;
    }
    Packed packed{.placements = plan(inner, {.should_stop = watch.should_stop}).placements};
    for (Placement& at : packed.placements)
        at.offset = at.offset + origin;
    packed.item.previous = Placement{.scale = to_source_px(packed.placements)};
    packed.item.item = as_one(request, group, packed.placements);
    return packed;
}

Packed packed_group(const PlanRequest& request, const Group& group, const PlanWatch& watch) {
    if (group.size() == 1) return {.placements = {Placement{}}, .item = request.items[group[0]]};
    const bool any_stands = std::any_of(group.begin(), group.end(),
                                        [&](std::size_t i) { return request.items[i].previous.has_value(); });
    if (any_stands && stands(request, group)) return packed_again(request, group, watch);
    return packed_anew(request, group, watch);
}

}  // namespace

Layout plan_nested(const PlanRequest& request, const PlanWatch& watch) {
    const std::vector<Group> groups = groups_of(request);
    std::vector<Packed> packed;
    PlanRequest outer = request;
    outer.items.clear();
    for (const Group& group : groups) {
        packed.push_back(packed_group(request, group, watch));
        outer.items.push_back(packed.back().item);
        outer.items.back().group = PlanItem::no_group;
    }
    const Layout whole = plan(outer, {.should_stop = watch.should_stop});
    Layout layout{.canvas = request.canvas, .placements = std::vector<Placement>(request.items.size())};
    double covered = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const Placement& at = whole.placements[g];
        for (std::size_t k = 0; k < groups[g].size(); ++k) {
            const std::size_t i = groups[g][k];
            const Placement& inner = packed[g].placements[k];
            layout.placements[i] = {inner.scale * at.scale, inner.offset * at.scale + at.offset};
            covered += seat_of(request.items[i].item, layout.placements[i]).area;
        }
        if (groups[g].size() > 1) layout.groups.push_back({groups[g]});
    }
    layout.energy = 1 - covered / (request.canvas.x * request.canvas.y);
    return layout;
}

Layout planned(const PlanRequest& request, const PlanWatch& watch) {
    const bool is_nested = std::any_of(request.items.begin(), request.items.end(),
                                       [](const PlanItem& item) { return item.group != PlanItem::no_group; });
    return is_nested ? plan_nested(request, watch) : plan(request, watch);
}

}  // namespace vitrine
