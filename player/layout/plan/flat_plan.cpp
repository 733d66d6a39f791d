#include "player/layout/plan/flat_plan.hpp"

#include "player/layout/pack/arrangement.hpp"
#include "player/layout/pack/coarse_filling.hpp"
#include "player/layout/pack/descent.hpp"
#include "player/layout/pack/few_items.hpp"
#include "player/layout/pack/filling.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "player/layout/pack/line_packing.hpp"
#include "player/layout/pack/optimizer.hpp"
#include "player/layout/pack/separation.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/pack/sliver_filling.hpp"
#include "player/layout/plan/bands.hpp"
#include "player/layout/plan/motion.hpp"
#include "player/layout/plan/plan_by_outputs.hpp"
#include "player/layout/plan/seat_exchanges.hpp"
#include "player/layout/plan/warm_start.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double filling_share = 0.3;  // share of the budget, in addition to it
constexpr double usual_share = 0.5;    // covered share of the canvas after the initial packing

/// The largest scale at which an item's region lies inside the field.
double fitting_scale(const Shape& shape, const Box& field) {
    return std::min(field.width() / shape.extent.width(), field.height() / shape.extent.height());
}

std::vector<LayoutItem> items_of(const PlanRequest& request) {
    std::vector<LayoutItem> items;
    items.reserve(request.items.size());
    for (const PlanItem& entry : request.items)
        items.push_back(entry.item);
    return items;
}

/// The items' relative scales by their weights. A band has its own scale.
std::vector<double> scales_of(const PlanRequest& request, const PackingProblem& problem) {
    const std::vector<LayoutItem> items = items_of(request);
    const std::span all(items);
    std::vector<double> scales =
        natural_scales(all.first(problem.items()), std::span(problem.shapes).first(problem.items()));
    scales.resize(problem.size(), 1);
    return scales;
}

/// The problem with relative scales.
PackingProblem problem_of(const PlanRequest& request) {
    PackingProblem problem;
    problem.clearance = std::max(request.clearance, min_clearance);
    const double max_margin = std::min(request.canvas.x, request.canvas.y) / 4;
    const double edge = std::clamp(request.margin, min_clearance, max_margin);
    problem.field = {{edge, edge}, request.canvas - Vec2{edge, edge}};
    problem.canvas = {{0, 0}, request.canvas};
    for (const PlanItem& entry : request.items) {
        problem.shapes.push_back(shape_of(entry.item.region));
        problem.pinned.push_back(has_pinned_place(entry));
        const Placement at = entry.previous.value_or(Placement{});
        problem.pinned_places.push_back(problem.shapes.back().centroid * at.scale + at.offset);
        if (entry.is_band) ++problem.bands;
    }
    problem.keeps_order = request.order == LayoutOrder::reading;
    problem.scales = scales_of(request, problem);
    for (std::size_t i = 0; i < problem.size(); ++i)
        problem.limits.push_back(
            i < problem.items() ? std::min(request.max_scale, fitting_scale(problem.shapes[i], problem.field))
                                : 1);
    return problem;
}

/// Converts the relative scales to canvas px: at a growth of 1 they then cover the usual share. An item that
/// would not fit on the canvas at that size is made smaller, so that it does not shrink the others.
void bring_to_canvas(const PlanRequest& request, PackingProblem& problem) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        double sum = 0;
        for (std::size_t i = 0; i < problem.items(); ++i)
            sum += problem.shapes[i].area * problem.scales[i] * problem.scales[i];
        const double growth = std::sqrt(usual_share * problem.field.area() / sum);
        for (std::size_t i = 0; i < problem.items(); ++i)
            problem.scales[i] =
                std::min(problem.scales[i] * growth, fitting_scale(problem.shapes[i], problem.field));
    }
    for (std::size_t i = 0; i < problem.size(); ++i)
        if (problem.pinned[i]) problem.scales[i] = request.items[i].previous->scale;
}

PackingProblem problem_on_canvas(const PlanRequest& request) {
    PackingProblem problem = problem_of(request);
    bring_to_canvas(request, problem);
    return problem;
}

/// Moves a packing from around the origin onto the field, as large as it is free there.
Arrangement fitted(const PackingProblem& problem, std::span<const Vec2> places, Contacts& contacts) {
    const Box bounds = bounds_of({problem.shapes, problem.scales}, places);
    const double fit =
        std::min(problem.field.width() / bounds.width(), problem.field.height() / bounds.height());
    Arrangement arrangement;
    for (const Vec2& place : places)
        arrangement.places.push_back(problem.field.centre() + (place - bounds.centre()) * fit);
    const double min_growth = fit * 1e-3;  // touching shapes that shrink about inner points come apart
    arrangement.growth = max_free_growth(problem, arrangement, contacts, min_growth, fit);
    return arrangement;
}

/// The initial packing: in lines if the order matters, else the better of two orders around the first item.
Arrangement packed(const PackingProblem& problem, double ratio) {
    Contacts contacts(problem.shapes, problem.clearance);
    const ScaledShapes shapes{problem.shapes, problem.scales};
    if (problem.keeps_order) return fitted(problem, packed_in_lines(shapes, ratio), contacts);
    Contacts touching(problem.shapes, 0);
    touching.set_scales(problem.scales);
    Arrangement best;
    best.growth = -1;
    for (const PackingOrder order : {PackingOrder::largest_first, PackingOrder::as_given}) {
        constexpr std::size_t max_packed_twice = 48;
        if (order == PackingOrder::as_given && problem.size() > max_packed_twice) break;
        const Arrangement next = fitted(problem, initial_packing(shapes, touching, ratio, order), contacts);
        if (next.growth > best.growth) best = next;
    }
    return best;
}

/// The frame of each item relative to the centroid of its region, source px.
std::vector<Box> frames_of(const PlanRequest& request, const PackingProblem& problem) {
    std::vector<Box> frames;
    frames.reserve(problem.size());
    for (std::size_t i = 0; i < problem.size(); ++i)
        frames.push_back(moved(request.items[i].item.core, problem.shapes[i].centroid * -1));
    return frames;
}

/// The items' places before a change; for newcomers, the places where they came in.
std::vector<Vec2> homes_of(const PlanRequest& request, const PackingProblem& problem,
                           const Arrangement& changed) {
    std::vector<Vec2> homes = changed.places;
    for (std::size_t i = 0; i < homes.size(); ++i)
        if (const PlanItem& item = request.items[i]; item.previous) {
            const Placement at = item.home.value_or(*item.previous);
            homes[i] = problem.shapes[i].centroid * at.scale + at.offset;
        }
    return homes;
}

bool has_kept_items(const PlanRequest& request) {
    return std::any_of(request.items.begin(), request.items.end(),
                       [](const PlanItem& item) { return item.previous.has_value() && !item.is_band; });
}

bool has_pinned_items(const PlanRequest& request) {
    return std::ranges::any_of(request.items,
                               [](const PlanItem& item) { return item.is_pinned && !item.is_band; });
}

/// True if a placed item may be moved.
bool has_movable_items(const PlanRequest& request) {
    return std::any_of(request.items.begin(), request.items.end(),
                       [](const PlanItem& item) { return item.previous.has_value() && !item.is_pinned; });
}

/// True if nothing but newcomers in the seats of others changes a wall.
bool is_turn(const PlanRequest& request) {
    const auto is_new = [](const PlanItem& item) { return !item.previous; };
    return request.fills && !has_pinned_items(request) && request.order == LayoutOrder::free &&
           has_movable_items(request) && std::ranges::any_of(request.items, is_new) &&
           std::ranges::all_of(request.items,
                               [&](const PlanItem& item) { return !is_new(item) || item.seat; });
}

/// The middle of what a newcomer covers of the seat that it takes over, which counts as a square here. None:
/// it covers too little.
std::optional<LayoutItem> guard_of(const PlanItem& newcomer, const Placement& placement) {
    const double half = 0.4 * std::sqrt(newcomer.seat->area);
    const Box seat{newcomer.seat->centre - Vec2{half, half}, newcomer.seat->centre + Vec2{half, half}};
    return guard_of_seat(clipped(placed_region(newcomer.item, placement), seat), seat.area());
}

/// True where the items that stay have a way to their new places that leaves the newcomers' seats free.
bool has_free_way(const PlanRequest& request, const Layout& layout) {
    std::vector<LayoutItem> items;
    std::vector<Placement> from, to;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const PlanItem& item = request.items[i];
        if (item.is_band) continue;
        if (item.previous) {
            items.push_back(item.item);
            from.push_back(*item.previous);
            to.push_back(layout.placements[i]);
        } else if (item.seat) {
            const auto guard = guard_of(item, layout.placements[i]);
            if (!guard) continue;
            items.push_back(*guard);
            from.emplace_back();
            to.emplace_back();
        }
    }
    return motion_between(items, from, to, request.canvas).has_value();
}

/// The making of one plan: uses up its random numbers and its budget.
class FlatPlan {
  public:
    /// @pre the request has items. Both are borrowed and must outlive this.
    FlatPlan(const PlanRequest& request, const PlanWatch& watch)
        : request_(request),
          watch_(watch),
          random_(request.seed),
          budget_(request.budget, watch.should_stop),
          problem_(problem_on_canvas(request)),
          ratio_(request.canvas.x / request.canvas.y) {}

    /// The paper's method: packs items in the given order, then descends eq. 3.4.
    Layout paper_layout() {
        Contacts contacts(problem_.shapes, 0);
        contacts.set_scales(problem_.scales);
        const ScaledShapes shapes{problem_.shapes, problem_.scales};
        const std::vector<Vec2> packing = initial_packing(shapes, contacts, ratio_, PackingOrder::as_given);
        const DescentResult end = descend(shapes, packing, ratio_, random_, budget_);
        Contacts apart(problem_.shapes, problem_.clearance);
        return layout_of(problem_, fitted(problem_, end.places, apart));
    }

    /// Moves kept items as little as possible. @return none: no such change was found
    std::optional<Layout> changed_layout() {
        PackingProblem problem = problem_;
        const auto settled = warm_start(request_, problem, random_, budget_);
        if (!settled) return std::nullopt;
        const Arrangement end = with_gaps_filled(problem, *settled, homes_of(request_, problem, *settled));
        return layout_of(problem, end);
    }

    /// Packs all items but pinned ones again, as large as possible.
    Layout fresh_layout() {
        const bool any_pinned =
            std::find(problem_.pinned.begin(), problem_.pinned.end(), true) != problem_.pinned.end();
        const Arrangement start = any_pinned ? scattered() : packed(problem_, ratio_);
        const OnBetter tell = [&](const Arrangement& arrangement) {
            if (watch_.on_better) watch_.on_better(layout_of(problem_, arrangement));
        };
        tell(start);
        const Arrangement best = densest_arrangement(problem_, start, random_, budget_, tell);
        const Arrangement end = with_gaps_filled(problem_, best, {});
        return layout_of(problem_, end);
    }

  private:
    Layout layout_of(const PackingProblem& problem, const Arrangement& arrangement) const {
        Layout layout;
        layout.canvas = request_.canvas;
        for (std::size_t i = 0; i < problem.size(); ++i) {
            const double scale = problem.scale(i, arrangement.growth);
            const Vec2 offset = arrangement.places[i] - problem.shapes[i].centroid * scale;
            layout.placements.push_back(problem.pinned[i] ? *request_.items[i].previous
                                                          : Placement{scale, offset});
        }
        const double canvas_area = request_.canvas.x * request_.canvas.y;
        layout.energy = 1 - region_area(problem, arrangement.growth) / canvas_area;
        return layout;
    }

    /// An arrangement around pinned items, which the initial packing cannot respect, free of overlap. The
    /// other items shrink until they find room.
    Arrangement scattered() {
        constexpr int max_shrinks = 60;
        constexpr double shrink = 0.85;
        constexpr int patience = 6;
        Contacts contacts(problem_.shapes, problem_.clearance);
        Separation separation(problem_, contacts, random_);
        Arrangement arrangement;
        for (std::size_t i = 0; i < problem_.size(); ++i)
            arrangement.places.push_back(problem_.field.centre());
        SearchBudget unlimited(std::numeric_limits<std::int64_t>::max());
        for (int k = 0; k < max_shrinks; ++k, arrangement.growth *= shrink) {
            for (std::size_t i = 0; i < problem_.size(); ++i)
                if (problem_.pinned[i]) arrangement.places[i] = problem_.pinned_places[i];
            SearchBudget& budget = budget_.is_spent() ? unlimited : budget_;
            if (separation.run(arrangement, {}, budget, patience)) break;
        }
        return arrangement;
    }

    /// The last step of every layout. @param homes  canvas px; the items stay near them; none: they may go
    /// anywhere
    Arrangement with_gaps_filled(PackingProblem& problem, const Arrangement& arrangement,
                                 std::vector<Vec2> homes) {
        if (!request_.fills) return arrangement;
        if (request_.is_coarse) return coarsely_filled(problem, frames_of(request_, problem), arrangement);
        const FillingTargets targets = filling_targets(problem, std::move(homes));
        const Arrangement filled = filled_once(problem, targets, arrangement);
        return slivers_filled(problem, targets.frames, filled_again(problem, targets, filled));
    }

    /// Fills again, with farther moves, while a hole stays that this makes smaller.
    Arrangement filled_again(PackingProblem& problem, FillingTargets targets, Arrangement filled) {
        constexpr double max_hole = 0.003;  // share of the canvas
        constexpr double min_gain = 0.001;
        constexpr int max_tries = 3;
        if (is_for_few(problem)) return filled;
        targets.emptiness *= 2;
        targets.max_way *= 2;
        double hole = unfilled_share(problem, targets.frames, filled);
        for (int tries = 0; tries < max_tries && hole > max_hole; ++tries) {
            PackingProblem trial = problem;
            Arrangement again = filled_once(trial, targets, filled);
            const double left = unfilled_share(trial, targets.frames, again);
            if (left > hole - min_gain) break;
            problem = std::move(trial);
            filled = std::move(again);
            hole = left;
        }
        return filled;
    }

    Arrangement filled_once(PackingProblem& problem, const FillingTargets& targets,
                            const Arrangement& arrangement) {
        SearchBudget budget(static_cast<std::int64_t>(static_cast<double>(request_.budget) * filling_share),
                            watch_.should_stop);
        return is_for_few(problem) ? few_filled(problem, targets, arrangement, random_, budget)
                                   : fill_gaps(problem, targets, arrangement, random_, budget);
    }

    FillingTargets filling_targets(const PackingProblem& problem, std::vector<Vec2> homes) const {
        FillingTargets targets{.frames = frames_of(request_, problem),
                               .natural = scales_of(request_, problem),
                               .homes = std::move(homes)};
        if (!targets.homes.empty())
            targets.is_reachable = [this](const PackingProblem& of, const Arrangement& made) {
                return has_free_way(request_, layout_of(of, made));
            };
        return targets;
    }

    const PlanRequest& request_;  // outlives this
    const PlanWatch& watch_;      // outlives this
    Random random_;
    SearchBudget budget_;
    PackingProblem problem_;
    double ratio_;  // width / height of the canvas
};

/// The share of the canvas without a picture. @param frames  of the problem's items
double hole_of(PackingProblem problem, const std::vector<Box>& frames, const Layout& layout) {
    Arrangement arrangement{{}, 1};
    for (std::size_t i = 0; i < problem.size(); ++i) {
        const Placement& at = layout.placements[i];
        problem.scales[i] = at.scale;
        arrangement.places.push_back(problem.shapes[i].centroid * at.scale + at.offset);
    }
    return unfilled_share(problem, frames, arrangement);
}

/// False where the pictures are so small that holes have to be expected.
bool can_be_filled(const PackingProblem& problem, const std::vector<Box>& frames) {
    constexpr double min_area = 1.2;  // of the pictures at their largest, share of the canvas
    double sum = 0;
    for (std::size_t i = 0; i < problem.items(); ++i)
        sum += frames[i].area() * problem.limits[i] * problem.limits[i];
    return sum >= min_area * problem.whole().area();
}

/// Fills the hole that a change has left and no growth can fill: a newcomer and a kept item exchange their
/// places, or else all is laid out anew.
Layout without_hole(const PlanRequest& request, const PlanWatch& watch, Layout layout) {
    constexpr double max_hole = 0.006;  // share of the canvas
    constexpr double min_gain = 0.004;
    constexpr double min_gain_of_all = 0.05;
    if (!request.fills || request.is_coarse || request.order == LayoutOrder::reading) return layout;
    const PackingProblem problem = problem_of(request);
    if (is_for_few(problem) || problem.size() > max_filled) return layout;
    const std::vector<Box> frames = frames_of(request, problem);
    double hole = hole_of(problem, frames, layout);
    if (hole <= max_hole || !can_be_filled(problem, frames)) return layout;
    const PlanWatch untold{.should_stop = watch.should_stop};
    for (const PlanRequest& exchanged : seat_exchanges(request)) {
        const auto other = FlatPlan(exchanged, untold).changed_layout();
        const double left = other ? hole_of(problem, frames, *other) : 1;
        if (left > hole - min_gain || !has_free_way(request, *other)) continue;
        layout = *other;
        hole = left;
        if (hole <= max_hole) return layout;
    }
    if (has_pinned_items(request)) return layout;
    const Layout fresh = FlatPlan(request, untold).fresh_layout();
    return hole_of(problem, frames, fresh) <= hole - min_gain_of_all ? fresh : layout;
}

/// @pre the bands of the canvas are items of the request
Layout planned_flat(const PlanRequest& request, const PlanWatch& watch) {
    FlatPlan plan(request, watch);
    if (request.energy == EnergyMode::paper) return plan.paper_layout();
    if (has_movable_items(request))
        if (auto changed = plan.changed_layout()) return without_hole(request, watch, *std::move(changed));
    return plan.fresh_layout();
}

/// A plan of a canvas with bands. A new wall is planned as a whole, and each output by itself; the better
/// plan is taken.
Layout plan_with_bands(const PlanRequest& request, const PlanWatch& watch) {
    const auto by_outputs = [&] {
        return plan_by_outputs(request, {.should_stop = watch.should_stop}, plan_flat);
    };
    if (request.energy == EnergyMode::paper) return by_outputs();
    if (is_turn(request)) {
        const PlanWatch untold{.should_stop = watch.should_stop};
        std::optional<Layout> changed = change_by_outputs(request, untold, plan_flat);
        if (changed && is_clear_of_bands(request, changed->placements)) return *std::move(changed);
    }
    const PlanWatch told = without_bands(watch, request);
    Layout whole = without_bands(planned_flat(with_bands(request), told), request);
    const bool is_clear = is_clear_of_bands(request, whole.placements);
    if (is_clear && (has_movable_items(request) || request.order == LayoutOrder::reading)) return whole;
    Layout parts = best_plan_by_outputs(request, {.should_stop = watch.should_stop}, plan_flat);
    return is_clear && cost_of_plan(request, whole) <= cost_of_plan(request, parts) ? whole : parts;
}

}  // namespace

std::optional<Layout> plan_change(const PlanRequest& request, const PlanWatch& watch) {
    if (!has_kept_items(request)) return std::nullopt;
    if (request.canvas.bands.empty()) return FlatPlan(request, watch).changed_layout();
    const PlanRequest with = with_bands(request);
    const std::optional<Layout> changed = FlatPlan(with, without_bands(watch, request)).changed_layout();
    if (!changed) return std::nullopt;
    Layout layout = without_bands(*changed, request);
    return is_clear_of_bands(request, layout.placements) ? std::optional(std::move(layout)) : std::nullopt;
}

Layout plan_flat(const PlanRequest& request, const PlanWatch& watch) {
    assert(request.canvas.x > 0 && request.canvas.y > 0);
    if (request.items.empty()) return {.canvas = request.canvas, .energy = 1};
    return request.canvas.bands.empty() ? planned_flat(request, watch) : plan_with_bands(request, watch);
}

}  // namespace vitrine::player
