#include "player/layout/plan/flat_plan.hpp"

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/descent.hpp"
#include "player/layout/pack/filling.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "player/layout/pack/optimizer.hpp"
#include "player/layout/pack/separation.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/warm_start.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vitrine::player {

namespace {

constexpr double least_clearance = 1.0 / 64;  // canvas px; the grid of exact areas rounds by 1/512
constexpr double filling_share = 0.3;         // of the budget, and on top of it
constexpr double usual_share = 0.5;           // of the canvas covered after initial packing

/// The largest scale at which an item's region lies inside the field.
double fitting_scale(const Shape& shape, const Box& field) {
    return std::min(field.width() / shape.extent.width(), field.height() / shape.extent.height());
}

Ground ground_of(const PlanRequest& request) {
    Ground ground;
    ground.clearance = std::max(request.clearance, least_clearance);
    const double most_margin = std::min(request.canvas.x, request.canvas.y) / 4;
    const double edge = std::clamp(request.margin, least_clearance, most_margin);
    ground.field = {{edge, edge}, request.canvas - Vec2{edge, edge}};
    std::vector<LayoutItem> items;
    for (const PlanItem& entry : request.items) {
        items.push_back(entry.item);
        ground.shapes.push_back(shape_of(entry.item.region));
        ground.pinned.push_back(entry.is_pinned && entry.previous.has_value());
        const Placement at = entry.previous.value_or(Placement{});
        ground.pinned_places.push_back(ground.shapes.back().centroid * at.scale + at.offset);
    }
    ground.reads = request.order == LayoutOrder::reading;
    ground.scales = natural_scales(items, ground.shapes);
    for (const Shape& shape : ground.shapes)
        ground.limits.push_back(std::min(request.most_scale, fitting_scale(shape, ground.field)));
    return ground;
}

/// Brings the relative scales to canvas px: a growth of 1 then covers the usual share. What would not fit
/// on the canvas at that size is made smaller, so that it does not shrink the others.
void bring_to_canvas(const PlanRequest& request, Ground& ground) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        double sum = 0;
        for (std::size_t i = 0; i < ground.size(); ++i)
            sum += ground.shapes[i].area * ground.scales[i] * ground.scales[i];
        const double growth = std::sqrt(usual_share * ground.field.area() / sum);
        for (std::size_t i = 0; i < ground.size(); ++i)
            ground.scales[i] =
                std::min(ground.scales[i] * growth, fitting_scale(ground.shapes[i], ground.field));
    }
    for (std::size_t i = 0; i < ground.size(); ++i)
        if (ground.pinned[i]) ground.scales[i] = request.items[i].previous->scale;
}

/// Brings a packing round the origin onto the field, as large as it is free there.
Arrangement fitted(const Ground& ground, std::span<const Vec2> places, Contacts& contacts) {
    const Box bounds = bounds_of(ground.shapes, ground.scales, places);
    const double fit =
        std::min(ground.field.width() / bounds.width(), ground.field.height() / bounds.height());
    Arrangement arrangement;
    for (const Vec2& place : places)
        arrangement.places.push_back(ground.field.centre() + (place - bounds.centre()) * fit);
    const double least = fit * 1e-3;  // touching shapes made smaller about inner points are apart
    arrangement.growth = greatest_growth(ground, arrangement, contacts, least, fit);
    return arrangement;
}

Arrangement packed(const Ground& ground, double ratio) {
    Contacts contacts(ground.shapes, ground.clearance);
    if (ground.reads) return fitted(ground, packed_in_lines(ground.shapes, ground.scales, ratio), contacts);
    Contacts touching(ground.shapes, 0);
    touching.set_scales(ground.scales);
    Arrangement best;
    best.growth = -1;
    for (const PackingOrder order : {PackingOrder::largest_first, PackingOrder::as_given}) {
        constexpr std::size_t most_packed_twice = 48;
        if (order == PackingOrder::as_given && ground.size() > most_packed_twice) break;
        const std::vector<Vec2> places =
            initial_packing(ground.shapes, touching, ground.scales, ratio, order);
        const Arrangement next = fitted(ground, places, contacts);
        if (next.growth > best.growth) best = next;
    }
    return best;
}

Layout layout_of(const PlanRequest& request, const Ground& ground, const Arrangement& arrangement) {
    Layout layout;
    layout.canvas = request.canvas;
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double scale = ground.scale(i, arrangement.growth);
        const Vec2 offset = arrangement.places[i] - ground.shapes[i].centroid * scale;
        layout.placements.push_back(ground.pinned[i] ? *request.items[i].previous : Placement{scale, offset});
    }
    const double canvas_area = request.canvas.x * request.canvas.y;
    layout.energy = 1 - region_area(ground, arrangement.growth) / canvas_area;
    return layout;
}

/// Free of overlap round pinned items, which the initial packing cannot respect. The others shrink until they
/// find room.
Arrangement scattered(const Ground& ground, Random& random, Effort& effort) {
    constexpr int most_shrinks = 60;
    constexpr double shrink = 0.85;
    constexpr int patience = 6;
    Contacts contacts(ground.shapes, ground.clearance);
    Separation separation(ground, contacts, random);
    Arrangement arrangement;
    for (std::size_t i = 0; i < ground.size(); ++i)
        arrangement.places.push_back(ground.field.centre());
    Effort unlimited(std::numeric_limits<std::int64_t>::max());
    for (int k = 0; k < most_shrinks; ++k, arrangement.growth *= shrink) {
        for (std::size_t i = 0; i < ground.size(); ++i)
            if (ground.pinned[i]) arrangement.places[i] = ground.pinned_places[i];
        if (separation.run(arrangement, {}, effort.is_spent() ? unlimited : effort, patience)) break;
    }
    return arrangement;
}

/// The paper's way: items packed as given, then eq. 3.4 descended.
Arrangement papers_way(const Ground& ground, double ratio, Random& random, Effort& effort) {
    Contacts contacts(ground.shapes, 0);
    contacts.set_scales(ground.scales);
    const std::vector<Vec2> packing =
        initial_packing(ground.shapes, contacts, ground.scales, ratio, PackingOrder::as_given);
    const Descended end = descended(ground.shapes, ground.scales, packing, ratio, random, effort);
    Contacts apart(ground.shapes, ground.clearance);
    return fitted(ground, end.places, apart);
}

/// What each item can show, about the centroid of its region, source px.
std::vector<Box> frames_of(const PlanRequest& request, const Ground& ground) {
    std::vector<Box> frames;
    frames.reserve(ground.size());
    for (std::size_t i = 0; i < ground.size(); ++i)
        frames.push_back(moved(request.items[i].item.core, ground.shapes[i].centroid * -1));
    return frames;
}

/// The finish of every layout: what is left over is used up.
Arrangement finished(const PlanRequest& request, Ground& ground, const Arrangement& arrangement,
                     std::vector<Vec2> homes, Random& random, const PlanWatch& watch) {
    if (!request.fills) return arrangement;
    std::vector<LayoutItem> items;
    for (const PlanItem& entry : request.items)
        items.push_back(entry.item);
    const FillingWishes wishes{.frames = frames_of(request, ground),
                               .natural = natural_scales(items, ground.shapes),
                               .homes = std::move(homes)};
    Effort effort(static_cast<std::int64_t>(static_cast<double>(request.budget) * filling_share),
                  watch.should_stop);
    return filled(ground, wishes, arrangement, random, effort);
}

/// Where the items of a change stood, or stand now that are new.
std::vector<Vec2> homes_of(const PlanRequest& request, const Ground& ground, const Arrangement& changed) {
    std::vector<Vec2> homes = changed.places;
    for (std::size_t i = 0; i < homes.size(); ++i)
        if (const PlanItem& item = request.items[i]; item.previous) {
            const Placement at = item.home.value_or(*item.previous);
            homes[i] = ground.shapes[i].centroid * at.scale + at.offset;
        }
    return homes;
}

bool is_warm(const PlanRequest& request) {
    return std::any_of(request.items.begin(), request.items.end(),
                       [](const PlanItem& item) { return item.previous.has_value(); });
}

/// Whether anything stands that would rather not move.
bool can_be_disturbed(const PlanRequest& request) {
    return std::any_of(request.items.begin(), request.items.end(),
                       [](const PlanItem& item) { return item.previous.has_value() && !item.is_pinned; });
}

std::optional<Layout> changed_layout(const PlanRequest& request, Ground standing, const PlanWatch& watch,
                                     Random& random, Effort& effort) {
    if (!is_warm(request)) return std::nullopt;
    const auto settled = warm_start(request, standing, random, effort);
    if (!settled) return std::nullopt;
    std::vector<Vec2> homes = homes_of(request, standing, *settled);
    const Arrangement end = finished(request, standing, *settled, std::move(homes), random, watch);
    return layout_of(request, standing, end);
}

}  // namespace

std::optional<Layout> plan_change(const PlanRequest& request, const PlanWatch& watch) {
    if (request.items.empty()) return std::nullopt;
    Random random(request.seed);
    Effort effort(request.budget, watch.should_stop);
    Ground ground = ground_of(request);
    bring_to_canvas(request, ground);
    return changed_layout(request, ground, watch, random, effort);
}

Layout plan(const PlanRequest& request, const PlanWatch& watch) {
    assert(request.canvas.x > 0 && request.canvas.y > 0);
    if (request.items.empty()) return {.canvas = request.canvas, .energy = 1};
    Random random(request.seed);
    Effort effort(request.budget, watch.should_stop);
    Ground ground = ground_of(request);
    bring_to_canvas(request, ground);
    const OnBetter tell = [&](const Arrangement& arrangement) {
        if (watch.on_better) watch.on_better(layout_of(request, ground, arrangement));
    };
    if (request.energy == EnergyMode::paper)
        return layout_of(request, ground,
                         papers_way(ground, request.canvas.x / request.canvas.y, random, effort));
    if (can_be_disturbed(request))
        if (const auto changed = changed_layout(request, ground, watch, random, effort)) return *changed;
    const bool any_pinned =
        std::find(ground.pinned.begin(), ground.pinned.end(), true) != ground.pinned.end();
    const Arrangement start =
        any_pinned ? scattered(ground, random, effort) : packed(ground, request.canvas.x / request.canvas.y);
    tell(start);
    const Arrangement best = densest(ground, start, random, effort, tell);
    return layout_of(request, ground, finished(request, ground, best, {}, random, watch));
}

}  // namespace vitrine::player
