#include "player/layout/plan/plan.hpp"

#include "player/layout/plan/bands.hpp"
#include "player/layout/plan/flat_plan.hpp"
#include "player/layout/plan/kept_layout.hpp"
#include "player/layout/plan/neighbours.hpp"
#include "player/layout/plan/nesting.hpp"
#include "player/layout/plan/plan_by_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

/// True for a new wall on which like shots shall stand beside each other.
bool wants_alike(const PlanRequest& request) {
    constexpr std::size_t least = 3;  // two have one way to stand beside each other
    return request.neighbours == NeighbourChoice::alike && request.order == LayoutOrder::free &&
           request.energy == EnergyMode::screen && request.items.size() >= least &&
           std::ranges::none_of(request.items,
                                [](const PlanItem& item) { return item.previous.has_value(); });
}

Layout planned(const PlanRequest& request, const PlanWatch& watch) {
    const bool has_groups = std::any_of(request.items.begin(), request.items.end(), [](const PlanItem& item) {
        return item.group != PlanItem::no_group;
    });
    if (!has_groups) {
        const Layout layout = plan_flat(request, watch);
        return wants_alike(request) ? with_alike_neighbours(request, layout, watch) : layout;
    }
    Layout layout = plan_nested(request, watch);
    if (is_clear_of_bands(request, layout.placements)) return layout;
    return plan_by_outputs(request, {.should_stop = watch.should_stop}, plan_nested);
}

/// True if pinned items are the only ones that have a place.
bool is_new_around_pinned(const PlanRequest& request) {
    const auto is_placed = [](const PlanItem& item) { return item.previous.has_value(); };
    return std::ranges::any_of(request.items, has_pinned_place) &&
           std::ranges::all_of(request.items,
                               [&](const auto& item) { return has_pinned_place(item) || !is_placed(item); });
}

/// The area of other items' I-Regions under a pinned item at a place, canvas px^2.
double covered_area(const PlanItem& item, const Placement& at, const PlanRequest& request) {
    const Box box = bounding_box(placed_region(item.item, at));
    const Vec2 around{request.clearance, request.clearance};
    double covered = 0;
    for (const PlanItem& other : request.items)
        if (&other != &item && other.previous)
            covered += std::abs(signed_area(
                clipped(placed_region(other.item, *other.previous), {box.min - around, box.max + around})));
    return covered;
}

/// Puts a pinned item where it covers least. @return  true: it covers no I-Region
bool take_best_place(PlanItem& item, const PlanRequest& request) {
    Placement best = *item.previous;
    double least = covered_area(item, best, request);
    for (const Vec2& way : item.instead) {
        const Placement other{item.previous->scale, item.previous->offset + way};
        const double covered = covered_area(item, other, request);
        if (covered >= least) continue;
        least = covered;
        best = other;
    }
    item.previous = best;
    return least <= 0;
}

}  // namespace

Layout plan(const PlanRequest& request, const PlanWatch& watch) {
    if (std::optional<Layout> kept = kept_layout(request)) return std::move(*kept);
    if (!is_new_around_pinned(request)) return planned(request, watch);
    PlanRequest without = request;
    std::erase_if(without.items, has_pinned_place);
    if (without.items.empty()) return planned(request, watch);
    const Layout free = planned(without, {.should_stop = watch.should_stop});
    PlanRequest around = request;
    auto placement = free.placements.begin();
    for (PlanItem& item : around.items)
        if (!has_pinned_place(item)) item.previous = *placement++;
    bool is_clear = true;
    for (PlanItem& item : around.items)
        if (has_pinned_place(item)) is_clear = take_best_place(item, around) && is_clear;
    if (!is_clear) return planned(around, watch);
    Layout layout = free;
    layout.placements.clear();
    for (const PlanItem& item : around.items)
        layout.placements.push_back(*item.previous);
    return layout;
}

}  // namespace vitrine::player
