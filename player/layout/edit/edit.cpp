#include "player/layout/edit/edit.hpp"

#include "player/layout/edit/edit_window.hpp"
#include "player/layout/edit/motion.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/plan.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

Vec2 place_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

Placement placed_about(const LayoutItem& item, Vec2 place, double scale) {
    return {scale, place - shape_of(item.region).centroid * scale};
}

PlanRequest request_of(const WallState& wall, const EditRules& rules) {
    PlanRequest request{.canvas = wall.canvas,
                        .seed = rules.seed,
                        .budget = rules.budget,
                        .clearance = rules.clearance,
                        .margin = rules.margin,
                        .max_scale = rules.max_scale};
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        request.items.push_back({.item = wall.items[i],
                                 .previous = wall.placements[i],
                                 .home = wall.homes[i],
                                 .is_pinned = wall.pinned[i]});
    return request;
}

bool is_sound(const std::vector<LayoutItem>& items, const Layout& layout) {
    if (items.empty()) return true;
    const Measure measure = measured(items, layout.placements);
    return measure.hidden == 0 && is_box_within(measure.bounds, {{0, 0}, layout.canvas});
}

std::vector<LayoutItem> items_of(const PlanRequest& request) {
    std::vector<LayoutItem> items;
    for (const PlanItem& item : request.items)
        items.push_back(item.item);
    return items;
}

/// The wall by the request's plan. None: the plan is no sound layout.
std::optional<WallState> planned_wall(const WallState& wall, const PlanRequest& request, const Box& window,
                                      const EditRules& rules) {
    const std::optional<Layout> layout = planned_in(window, request, {.should_stop = rules.should_stop});
    std::vector<LayoutItem> items = items_of(request);
    if (!layout || !is_sound(items, *layout)) return std::nullopt;
    WallState next{.canvas = request.canvas,
                   .items = std::move(items),
                   .placements = layout->placements,
                   .homes = layout->placements,
                   .pinned = wall.pinned};
    next.pinned.resize(next.items.size(), false);
    return next;
}

/// Packs everything again, for a wall without a change plan.
WallState packed_anew(const WallState& wall, PlanRequest request, const EditRules& rules) {
    for (PlanItem& item : request.items) {
        if (!item.is_pinned) item.previous.reset();
        item.seat.reset();
    }
    const Layout layout = plan(request, {.should_stop = rules.should_stop});
    WallState next = wall_state(items_of(request), layout);
    next.pinned = wall.pinned;
    next.pinned.resize(next.items.size(), false);
    return next;
}

bool is_on_pinned(const WallState& wall, std::size_t item, const Placement& at, double clearance) {
    for (std::size_t j = 0; j < wall.items.size(); ++j) {
        if (j == item || !wall.pinned[j]) continue;
        const Placement& other = wall.placements[j];
        if (!overlap_interval({wall.items[item], at, at}, {wall.items[j], other, other}, clearance)
                 .is_empty())
            return true;
    }
    return false;
}

/// Puts an item down at a place; the others make room.
std::optional<WallState> put_down(const WallState& wall, std::size_t item, const Placement& at,
                                  const Box& window, const EditRules& rules) {
    if (is_on_pinned(wall, item, at, rules.clearance)) return std::nullopt;
    PlanRequest request = request_of(wall, rules);
    request.is_coarse = true;  // fine steps at every step of a finger would make items tremble
    request.items[item].previous = request.items[item].home = at;
    request.items[item].is_pinned = true;
    auto next = planned_wall(wall, request, window, rules);
    if (next) next->placements[item] = next->homes[item] = at;
    return next;
}

/// The usual scale of a newcomer among the items of a wall.
double usual_scale(const WallState& wall, const LayoutItem& newcomer) {
    if (wall.items.empty()) return 1;
    std::vector<LayoutItem> items = wall.items;
    items.push_back(newcomer);
    std::vector<Shape> shapes;
    shapes.reserve(items.size());
    for (const LayoutItem& item : items)
        shapes.push_back(shape_of(item.region));
    const std::vector<double> natural = natural_scales(items, shapes);
    std::vector<double> growths;
    growths.reserve(wall.items.size());
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        growths.push_back(wall.placements[i].scale / natural[i]);
    const auto middle = growths.begin() + static_cast<std::ptrdiff_t>(growths.size() / 2);
    std::nth_element(growths.begin(), middle, growths.end());
    return *middle * natural.back();
}

/// Puts the newcomer down at a place, smaller if necessary.
std::optional<WallState> put_in(const WallState& wall, const LayoutItem& newcomer, Vec2 place,
                                const EditRules& rules) {
    constexpr double factors[] = {0.95, 0.75, 0.5, 0.3};
    WallState with = wall;
    with.items.push_back(newcomer);
    with.pinned.push_back(false);
    const double scale = std::min(usual_scale(wall, newcomer), rules.max_scale);
    for (const double factor : factors) {
        const Placement at =
            moved_inside(newcomer, placed_about(newcomer, place, scale * factor), wall.canvas, rules.margin);
        with.placements.resize(wall.items.size());
        with.homes.resize(wall.items.size());
        with.placements.push_back(at);
        with.homes.push_back(at);
        if (auto next = put_down(with, wall.items.size(), at, window_at(wall, place, rules), rules))
            return next;
    }
    return std::nullopt;
}

}  // namespace

WallState inserted(const WallState& wall, const LayoutItem& newcomer, const EditRules& rules,
                   std::optional<Vec2> at) {
    if (at && !wall.items.empty())
        if (auto next = put_in(wall, newcomer, *at, rules)) return *next;
    PlanRequest request = request_of(wall, rules);
    request.items.push_back({.item = newcomer});
    if (at) request.items.back().seat = Seat{.centre = *at};
    const Vec2 place = at.value_or(emptiest_place(wall, rules));
    if (const auto next = planned_wall(wall, request, window_at(wall, place, rules), rules)) return *next;
    return packed_anew(wall, request, rules);
}

WallState deleted(const WallState& wall, std::size_t item, const EditRules& rules) {
    WallState rest = wall;
    const Vec2 place = place_of(wall.items[item], wall.placements[item]);
    const auto erase = [item](auto& from) { from.erase(from.begin() + static_cast<std::ptrdiff_t>(item)); };
    erase(rest.items);
    erase(rest.placements);
    erase(rest.homes);
    erase(rest.pinned);
    if (rest.items.empty()) return rest;
    return planned_wall(rest, request_of(rest, rules), window_at(rest, place, rules), rules).value_or(rest);
}

WallState replaced(const WallState& wall, std::size_t item, const LayoutItem& newcomer,
                   const EditRules& rules) {
    PlanRequest request = request_of(wall, rules);
    const Seat seat = seat_of(wall.items[item], wall.placements[item]);
    request.items[item] = {.item = newcomer, .seat = seat};
    WallState free = wall;
    free.pinned[item] = false;
    auto next = planned_wall(free, request, window_at(wall, seat.centre, rules), rules);
    if (!next) next = packed_anew(free, request, rules);
    next->pinned = wall.pinned;
    return *next;
}

WallState dragged(const WallState& wall, std::size_t item, Vec2 to, const EditRules& rules) {
    constexpr int tries = 6;
    const LayoutItem& touched = wall.items[item];
    const Vec2 from = place_of(touched, wall.placements[item]);
    const double scale = wall.placements[item].scale;
    double share = 1;  // share of the finger's way
    for (int k = 0; k < tries; ++k, share *= 0.6) {
        const Placement at = moved_inside(touched, placed_about(touched, from + (to - from) * share, scale),
                                          wall.canvas, rules.margin);
        const Box window =
            with_displaced(wall, united(window_at(wall, from, rules), window_at(wall, to, rules)));
        auto next = put_down(wall, item, at, window, rules);
        if (!next) continue;
        next->homes = wall.homes;
        next->homes[item] = at;
        return *next;
    }
    return wall;
}

WallState resized(const WallState& wall, std::size_t item, double factor, const EditRules& rules) {
    constexpr int tries = 6;
    const LayoutItem& touched = wall.items[item];
    const Shape shape = shape_of(touched.region);
    const Placement& now = wall.placements[item];
    const double fits = std::min((wall.canvas.x - 2 * rules.margin) / shape.extent.width(),
                                 (wall.canvas.y - 2 * rules.margin) / shape.extent.height());
    double scale = std::min({now.scale * factor, std::max(rules.max_scale, now.scale), fits});
    const Vec2 place = place_of(touched, now);
    for (int k = 0; k < tries; ++k, scale = std::sqrt(scale * now.scale)) {
        const Placement at =
            moved_inside(touched, placed_about(touched, place, scale), wall.canvas, rules.margin);
        if (auto next = put_down(wall, item, at, window_at(wall, place, rules), rules)) return *next;
    }
    return wall;
}

WallState settled(const WallState& wall, const EditRules& rules) {
    WallState now = wall;
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        now.homes[i] =
            placed_about(wall.items[i], place_of(wall.items[i], wall.placements[i]), wall.homes[i].scale);
    if (wall.items.empty()) return now;
    const Box all{{rules.margin, rules.margin}, wall.canvas - Vec2{rules.margin, rules.margin}};
    auto next = planned_wall(now, request_of(now, rules), all, rules);
    if (next) return *next;
    now.homes = now.placements;
    return now;
}

}  // namespace vitrine::player
