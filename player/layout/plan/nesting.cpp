#include "player/layout/plan/nesting.hpp"

#include "player/layout/plan/flat_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace vitrine::player {

namespace {

/// Items that are placed together, and the sum of their weights.
struct Group {
    std::vector<std::size_t> items;
    double weight = 0;
};

std::vector<Group> groups_of(const PlanRequest& request) {
    std::map<int, Group> named;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        Group& group = named[request.items[i].group];
        group.items.push_back(i);
        group.weight += request.items[i].item.weight;
    }
    std::vector<Group> groups;
    groups.reserve(named.size());
    for (auto& [name, group] : named)
        groups.push_back(std::move(group));
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& a, const Group& b) { return a.weight > b.weight; });
    return groups;
}

double weight_of(std::span<const Group> groups) {
    double sum = 0;
    for (const Group& group : groups)
        sum += group.weight;
    return sum;
}

/// Divides a box among groups: into two parts of about the same weight along its longer side, and so on.
void divide(std::span<const Group> groups, const Box& box, std::vector<Box>& parts) {
    if (groups.size() == 1) {
        parts.push_back(box);
        return;
    }
    const double whole = weight_of(groups);
    std::size_t count = 1;
    while (count + 1 < groups.size() && weight_of(groups.first(count)) < whole / 2)
        ++count;
    const double share = weight_of(groups.first(count)) / whole;
    Box first = box;
    Box second = box;
    if (box.width() >= box.height())
        first.max.x = second.min.x = box.min.x + box.width() * share;
    else
        first.max.y = second.min.y = box.min.y + box.height() * share;
    divide(groups.first(count), first, parts);
    divide(groups.subspan(count), second, parts);
}

/// Packs a group on its part of the canvas.
/// @return one placement for each item of the group, on the whole canvas
std::vector<Placement> packed(const PlanRequest& request, const Group& group, const Box& part,
                              const PlanWatch& watch) {
    PlanRequest inner = request;
    inner.canvas = part.max - part.min;
    inner.budget = request.budget * static_cast<std::int64_t>(group.items.size()) /
                   static_cast<std::int64_t>(request.items.size());
    inner.items.clear();
    for (const std::size_t i : group.items) {
        PlanItem item = request.items[i];
        if (item.previous) item.previous->offset = item.previous->offset - part.min;
        if (item.home) item.home->offset = item.home->offset - part.min;
        if (item.seat) item.seat->centre = item.seat->centre - part.min;
        inner.items.push_back(std::move(item));
    }
    std::vector<Placement> placements = plan_flat(inner, {.should_stop = watch.should_stop}).placements;
    for (Placement& at : placements)
        at.offset = at.offset + part.min;
    return placements;
}

}  // namespace

Layout plan_nested(const PlanRequest& request, const PlanWatch& watch) {
    Layout layout{.canvas = request.canvas, .placements = std::vector<Placement>(request.items.size())};
    layout.energy = 1;
    if (request.items.empty()) return layout;
    const std::vector<Group> groups = groups_of(request);
    std::vector<Box> parts;
    divide(groups, {{0, 0}, request.canvas}, parts);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::vector<std::size_t>& items = groups[g].items;
        const std::vector<Placement> placements = packed(request, groups[g], parts[g], watch);
        for (std::size_t k = 0; k < items.size(); ++k) {
            layout.placements[items[k]] = placements[k];
            const double area = seat_of(request.items[items[k]].item, placements[k]).area;
            layout.energy -= area / (request.canvas.x * request.canvas.y);
        }
        if (items.size() > 1 && request.items[items[0]].group != PlanItem::no_group)
            layout.groups.push_back({items});
    }
    return layout;
}

}  // namespace vitrine::player
