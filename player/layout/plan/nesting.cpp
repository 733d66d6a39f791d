#include "player/layout/plan/nesting.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/plan/flat_plan.hpp"
#include "player/layout/plan/free_box.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double aspect = 1.25;         // of the box for a group that is new
constexpr double group_weight = 1;      // of an item of a group, relative to one that stands alone
constexpr double reach = 0.1;           // of the pictures of a group around its box, as a share of its sides
constexpr double largest_growth = 1.5;  // of a placed group in one plan
constexpr std::int64_t least_budget = 30'000;  // of one group

/// One body: a group, or an item without a group.
struct Body {
    std::vector<std::size_t> items;
    PlanItem planned;
    bool is_group = false;
    bool is_whole = false;  // all its items are placed: it moves as a whole
    Polygon outline;        // canvas px: what is taken of the canvas
    Box box;                // canvas px: for the items of a group that is not whole
};

std::vector<Body> bodies_of(const PlanRequest& request) {
    std::vector<Body> bodies;
    std::map<int, std::size_t> known;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const int group = request.items[i].group;
        const auto [place, is_new] = known.try_emplace(group, bodies.size());
        if (group == PlanItem::no_group || is_new) bodies.emplace_back();
        (group == PlanItem::no_group ? bodies.back() : bodies[place->second]).items.push_back(i);
    }
    for (Body& body : bodies)
        body.is_group = request.items[body.items.front()].group != PlanItem::no_group;
    return bodies;
}

/// The placed items of a group as one item, in px of which `unit` canvas px are one.
PlanItem hull_item(const Body& body, const PlanRequest& request) {
    LayoutItem hull;
    Polygon points;
    double growth = largest_growth;
    for (const std::size_t i : body.items) {
        const PlanItem& item = request.items[i];
        if (!item.previous) continue;
        const Polygon region = placed_region(item.item, *item.previous);
        points.insert(points.end(), region.begin(), region.end());
        const Box core = placed_core(item.item, *item.previous);
        hull.core = hull.core.is_empty() ? core : united(hull.core, core);
        growth = std::min(growth, std::max(1.0, request.max_scale / item.previous->scale));
    }
    const double unit = request.max_scale / growth;  // so that the limit of the scale lets it grow no more
    hull.region = transformed(convex_hull(points), 1 / unit, {});
    hull.core = {hull.core.min * (1 / unit), hull.core.max * (1 / unit)};
    return {.item = hull, .previous = Placement{unit, {}}};
}

/// A box for a group that is new.
PlanItem box_item(const Body& body, const PlanRequest& request) {
    const Vec2 size{request.canvas.y * aspect, request.canvas.y};
    const Vec2 around = size * reach;
    PlanItem item{.item = {.region = to_polygon({around, around + size}), .core = {{}, size + around * 2}}};
    item.seat = request.items[body.items.front()].seat;
    return item;
}

void give_item(Body& body, const PlanRequest& request) {
    const auto is_placed = [&](std::size_t i) { return request.items[i].previous.has_value(); };
    body.is_whole = body.is_group && std::ranges::all_of(body.items, is_placed);
    if (!body.is_group) {
        body.planned = request.items[body.items.front()];
        return;
    }
    const bool is_new = std::ranges::none_of(body.items, is_placed);
    body.planned = is_new ? box_item(body, request) : hull_item(body, request);
    body.planned.item.weight = 0;
    for (const std::size_t i : body.items)
        body.planned.item.weight += request.items[i].item.weight * group_weight;
}

/// A box inside a convex outline, about its middle.
Box box_inside(const Polygon& outline) {
    constexpr double smaller = 0.9;
    const Box bounds = bounding_box(outline);
    const Vec2 middle = centroid(outline);
    Vec2 half = (bounds.max - bounds.min) * 0.5;
    const auto is_inside = [&] {
        return std::ranges::all_of(to_polygon({middle - half, middle + half}),
                                   [&](Vec2 corner) { return is_inside_convex(outline, corner); });
    };
    for (int k = 0; k < 60 && !is_inside(); ++k)
        half = half * smaller;
    return {middle - half, middle + half};
}

/// Gives the boxes the room between the bodies, in turns, so that none takes it all.
void grow_boxes(std::vector<Body>& bodies, const PlanRequest& request) {
    constexpr int rounds = 60;
    const double step = 0.01 * std::min(request.canvas.x, request.canvas.y);
    const Box field{{request.margin, request.margin}, request.canvas - Vec2{request.margin, request.margin}};
    bool has_grown = true;
    for (int k = 0; k < rounds && has_grown; ++k) {
        has_grown = false;
        for (Body& body : bodies) {
            if (!body.is_group || body.is_whole) continue;
            std::vector<Polygon> others;
            for (const Body& other : bodies)
                if (&other != &body) others.push_back(other.outline);
            for (const Box& band : request.canvas.bands)
                others.push_back(to_polygon(band));
            if (!grow_box(body.box, field, others, request.clearance, step)) continue;
            has_grown = true;
            body.outline = to_polygon(body.box);
        }
    }
}

/// The items of a group packed on its box. @param change  of the placed ones, with their body
std::vector<Placement> packed(const PlanRequest& request, const Body& body, const Placement& change,
                              const PlanWatch& watch) {
    PlanRequest inner = request;
    inner.canvas = canvas_within(request.canvas, body.box);
    inner.margin = 0;
    inner.budget = std::max(least_budget, request.budget * static_cast<std::int64_t>(body.items.size()) /
                                              static_cast<std::int64_t>(request.items.size()));
    inner.items.clear();
    for (const std::size_t i : body.items) {
        PlanItem item = request.items[i];
        const Placement shift{1, body.box.min * -1.0};
        if (item.previous) item.previous = composed(composed(*item.previous, change), shift);
        if (item.home) item.home = composed(composed(*item.home, change), shift);
        if (item.seat) item.seat->centre = item.seat->centre * change.scale + change.offset - body.box.min;
        if (!body.planned.previous) item.seat.reset();  // it was the seat of the whole group
        inner.items.push_back(std::move(item));
    }
    std::vector<Placement> placements = plan_flat(inner, {.should_stop = watch.should_stop}).placements;
    for (Placement& at : placements)
        at.offset = at.offset + body.box.min;
    return placements;
}

/// The layout of the bodies.
std::vector<Placement> placed_bodies(std::vector<Body>& bodies, const PlanRequest& request,
                                     const PlanWatch& watch) {
    PlanRequest outer = request;
    outer.items.clear();
    for (const Body& body : bodies)
        outer.items.push_back(body.planned);
    std::vector<Placement> placements = plan_flat(outer, {.should_stop = watch.should_stop}).placements;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Body& body = bodies[k];
        body.outline = placed_region(body.planned.item, placements[k]);
        if (!body.is_group || body.is_whole) continue;
        body.box = body.planned.previous ? box_inside(body.outline) : bounding_box(body.outline);
        body.outline = to_polygon(body.box);
    }
    return placements;
}

/// True: a group is alone on a canvas of several outputs, so that it may stand on all of them.
bool is_one_group(const std::vector<Body>& bodies, const PlanRequest& request) {
    if (request.canvas.bands.empty()) return false;
    const auto is_free = [&](const Body& body) { return !request.items[body.items.front()].is_pinned; };
    return std::ranges::count_if(bodies, is_free) == 1 &&
           std::ranges::all_of(bodies, [&](const Body& body) { return body.is_group == is_free(body); });
}

}  // namespace

Layout plan_nested(const PlanRequest& request, const PlanWatch& watch) {
    Layout layout{.canvas = request.canvas, .placements = std::vector<Placement>(request.items.size())};
    layout.energy = 1;
    if (request.items.empty()) return layout;
    std::vector<Body> bodies = bodies_of(request);
    if (is_one_group(bodies, request)) {
        layout = plan_flat(request, watch);
        for (const Body& body : bodies)
            if (body.is_group && body.items.size() > 1) layout.groups.push_back({body.items});
        return layout;
    }
    for (Body& body : bodies)
        give_item(body, request);
    const std::vector<Placement> placements = placed_bodies(bodies, request, watch);
    grow_boxes(bodies, request);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Body& body = bodies[k];
        const Placement change =
            body.planned.previous ? change_between(*body.planned.previous, placements[k]) : Placement{};
        std::vector<Placement> inner;
        if (body.is_group && !body.is_whole) inner = packed(request, body, change, watch);
        for (std::size_t n = 0; n < body.items.size(); ++n) {
            const std::size_t i = body.items[n];
            layout.placements[i] = !body.is_group  ? placements[k]
                                   : body.is_whole ? composed(*request.items[i].previous, change)
                                                   : inner[n];
            const double area = seat_of(request.items[i].item, layout.placements[i]).area;
            layout.energy -= area / (request.canvas.x * request.canvas.y);
        }
        if (body.is_group && body.items.size() > 1) layout.groups.push_back({body.items});
    }
    return layout;
}

}  // namespace vitrine::player
