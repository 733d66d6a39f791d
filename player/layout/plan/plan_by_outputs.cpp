#include "player/layout/plan/plan_by_outputs.hpp"

#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/bands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr int samples = 48;               // of an output, across and down
constexpr std::size_t max_shared = 16;    // items; more fill outputs well however they are shared out
constexpr int exchanges = 60;             // of items between outputs that are tried
constexpr std::int64_t quick_share = 10;  // a try of few items has this part of the budget
constexpr std::size_t few = 6;            // a try of more has less
constexpr double max_hole = 0.01;    // share of an output that no picture reaches after a change of its own
constexpr double emptiness = 3;      // cost of a canvas without pixels
constexpr double fullness = 2;       // what a canvas of I-Regions saves
constexpr double unevenness = 0.05;  // factor of the variance of ln(scale)
constexpr double tininess = 5;       // factor of the mean square of ln(scale) missing to a fair one
constexpr double fair_size = -0.15;  // ln(scale) relative to the natural one

/// The outputs, without those that overlap an earlier one.
std::vector<Box> separate_outputs(const Canvas& canvas) {
    std::vector<Box> outputs;
    for (const Box& output : canvas.outputs)
        if (std::ranges::all_of(outputs,
                                [&](const Box& other) { return intersection(output, other).is_empty(); }))
            outputs.push_back(output);
    if (outputs.empty()) outputs.push_back({{0, 0}, canvas});
    return outputs;
}

std::vector<double> wished_areas(const PlanRequest& request) {
    std::vector<LayoutItem> items;
    std::vector<Shape> shapes;
    for (const PlanItem& entry : request.items) {
        items.push_back(entry.item);
        shapes.push_back(shape_of(entry.item.region));
    }
    std::vector<double> areas = natural_scales(items, shapes);
    for (std::size_t i = 0; i < areas.size(); ++i)
        areas[i] *= areas[i] * shapes[i].area;
    return areas;
}

/// Shares bodies out to outputs.
class Sharing {
  public:
    explicit Sharing(const PlanRequest& request)
        : request_(&request),
          outputs_(separate_outputs(request.canvas)),
          output_of_(request.items.size(), nowhere),
          taken_(outputs_.size(), 0) {
        const std::vector<double> areas = wished_areas(request);
        for (Body& body : bodies_of_request()) {
            for (const std::size_t i : body.items)
                body.area += areas[i];
            bodies_.push_back(std::move(body));
        }
        std::ranges::stable_sort(bodies_, std::greater(), &Body::area);
        for (const Body& body : bodies_)
            if (const std::size_t output = present_output(body); output != nowhere) give(body, output);
        for (const Body& body : bodies_)
            if (output_of_[body.items.front()] == nowhere) give(body, roomiest());
    }

    const std::vector<Box>& outputs() const { return outputs_; }

    /// The items shared out to each output, by its number; rising.
    std::vector<std::vector<std::size_t>> items_of_outputs() const {
        std::vector<std::vector<std::size_t>> items(outputs_.size());
        for (std::size_t i = 0; i < output_of_.size(); ++i)
            if (output_of_[i] != nowhere) items[output_of_[i]].push_back(i);
        return items;
    }

    /// Exchanges two items of different outputs, or takes one to another output. Groups stay together.
    void disturb(Random& random) {
        const Body& a = bodies_[uniform_index(random, bodies_.size())];
        const Body& b = bodies_[uniform_index(random, bodies_.size())];
        const std::size_t from = output_of_[a.items.front()];
        const std::size_t to = output_of_[b.items.front()];
        if (from == to) {
            const std::size_t other = uniform_index(random, outputs_.size());
            const auto left = std::ranges::count(output_of_, from);
            if (left > std::ssize(a.items)) put(a, other);
            return;
        }
        put(a, to);
        put(b, from);
    }

    /// False: there is nothing to exchange.
    bool has_choice() const { return bodies_.size() > 1 && outputs_.size() > 1; }

  private:
    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

    struct Body {
        std::vector<std::size_t> items;
        double area = 0;  // wished, in any unit
    };

    /// Groups, and single items; without pinned ones.
    std::vector<Body> bodies_of_request() const {
        std::vector<Body> bodies;
        std::map<int, std::size_t> known;
        for (std::size_t i = 0; i < request_->items.size(); ++i) {
            const PlanItem& item = request_->items[i];
            if (has_pinned_place(item)) continue;
            const auto [place, is_new] = known.try_emplace(item.group, bodies.size());
            if (item.group == PlanItem::no_group || is_new) bodies.emplace_back();
            (item.group == PlanItem::no_group ? bodies.back() : bodies[place->second]).items.push_back(i);
        }
        return bodies;
    }

    /// The output on which most of a body's first placed item is.
    std::size_t present_output(const Body& body) const {
        for (const std::size_t i : body.items) {
            const PlanItem& item = request_->items[i];
            if (!item.previous && !item.seat) continue;
            const Box box = item.previous ? bounding_box(placed_region(item.item, *item.previous))
                                          : Box{item.seat->centre, item.seat->centre + Vec2{1, 1}};
            Canvas canvas = request_->canvas;
            canvas.outputs = outputs_;
            return static_cast<std::size_t>(std::ranges::find(outputs_, player::output_of(canvas, box)) -
                                            outputs_.begin());
        }
        return nowhere;
    }

    std::size_t roomiest() const {
        std::size_t best = 0;
        for (std::size_t k = 1; k < outputs_.size(); ++k)
            if (taken_[k] * outputs_[best].area() < taken_[best] * outputs_[k].area() ||
                (taken_[k] == 0 && taken_[best] == 0 && outputs_[k].area() > outputs_[best].area()))
                best = k;
        return best;
    }

    void put(const Body& body, std::size_t output) {
        for (const std::size_t i : body.items)
            output_of_[i] = output;
    }

    void give(const Body& body, std::size_t output) {
        put(body, output);
        taken_[output] += body.area;
    }

    const PlanRequest* request_;  // outlives this
    std::vector<Box> outputs_;
    std::vector<std::size_t> output_of_;  // one for each item
    std::vector<double> taken_;           // wished area, one for each output
    std::vector<Body> bodies_;
};

/// The pinned items that an output shows a part of.
std::vector<std::size_t> pinned_on(const PlanRequest& request, const Box& output) {
    std::vector<std::size_t> pinned;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const PlanItem& item = request.items[i];
        if (!has_pinned_place(item)) continue;
        const Box box = bounding_box(placed_region(item.item, *item.previous));
        if (!intersection(box, output).is_empty()) pinned.push_back(i);
    }
    return pinned;
}

/// The request of what one output shows.
PlanRequest request_on(const PlanRequest& request, const Box& output, const std::vector<std::size_t>& items) {
    PlanRequest part = request;
    part.canvas = Canvas(output.max - output.min);
    part.items.clear();
    const Placement shift{1, output.min * -1};
    for (const std::size_t i : items) {
        PlanItem item = request.items[i];
        if (item.previous) item.previous = composed(*item.previous, shift);
        if (item.home) item.home = composed(*item.home, shift);
        if (item.seat) item.seat->centre = item.seat->centre - output.min;
        part.items.push_back(std::move(item));
    }
    const auto share = static_cast<std::int64_t>(items.size());
    const auto all = static_cast<std::int64_t>(std::max<std::size_t>(1, request.items.size()));
    part.budget = std::max<std::int64_t>(1, request.budget * share / all);
    return part;
}

/// The parts of the canvas that are seen.
std::vector<Box> seen_parts(const Canvas& canvas) {
    return canvas.outputs.empty() ? std::vector<Box>{{{0, 0}, canvas}} : canvas.outputs;
}

/// The share of some parts of the canvas that no picture reaches, sampled.
double unseen_part(const PlanRequest& request, const Layout& layout, const std::vector<Box>& parts) {
    std::vector<Box> pictures;
    for (std::size_t i = 0; i < request.items.size(); ++i)
        pictures.push_back(placed_core(request.items[i].item, layout.placements[i]));
    int missing = 0;
    for (const Box& part : parts)
        for (int y = 0; y < samples; ++y)
            for (int x = 0; x < samples; ++x) {
                const Vec2 point{part.min.x + (x + 0.5) / samples * part.width(),
                                 part.min.y + (y + 0.5) / samples * part.height()};
                const bool is_seen = std::ranges::any_of(pictures, [&point](const Box& picture) {
                    return point.x >= picture.min.x && point.x <= picture.max.x && point.y >= picture.min.y &&
                           point.y <= picture.max.y;
                });
                if (!is_seen) ++missing;
            }
    return static_cast<double>(missing) / (samples * samples * static_cast<double>(parts.size()));
}

/// The cost of sizes that differ.
double spread_cost(const PlanRequest& request, const Layout& layout) {
    const std::vector<double> wished = wished_areas(request);
    std::vector<double> sizes;
    double mean = 0;
    for (std::size_t i = 0; i < wished.size(); ++i) {
        const double area = seat_of(request.items[i].item, layout.placements[i]).area;
        sizes.push_back(std::log(area / wished[i]) / 2);
        mean += sizes.back() / static_cast<double>(wished.size());
    }
    double cost = 0;
    for (const double size : sizes) {
        const double lack = std::max(0.0, fair_size - (size - mean));
        cost += unevenness * (size - mean) * (size - mean) + tininess * lack * lack;
    }
    return cost / static_cast<double>(std::max<std::size_t>(1, sizes.size()));
}

/// All items where they were. A new one is nowhere: a point.
Layout kept_places(const PlanRequest& request) {
    Layout layout{.canvas = request.canvas, .placements = {}};
    for (const PlanItem& item : request.items)
        layout.placements.push_back(item.previous.value_or(Placement{0, {}}));
    return layout;
}

/// Plans outputs one by one, and each only once for the same items.
class OutputPlans {
  public:
    /// @param request, watch, plan  outlive this
    OutputPlans(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan)
        : request_(&request),
          watch_(&watch),
          plan_(&plan),
          are_new_(std::ranges::none_of(request.items,
                                        [](const PlanItem& item) { return item.previous || item.seat; })) {}

    Layout planned_as(const Sharing& sharing) {
        Layout layout = kept_places(*request_);
        const std::vector<std::vector<std::size_t>> shared = sharing.items_of_outputs();
        for (std::size_t k = 0; k < shared.size(); ++k)
            add(sharing.outputs()[k], shared[k], layout);
        layout.energy = 1 - covered_px(*request_, layout) / (request_->canvas.x * request_->canvas.y);
        return layout;
    }

    /// Adds what one output shows.
    void add(const Box& output, std::vector<std::size_t> items, Layout& layout) {
        const std::vector<std::size_t> pinned = pinned_on(*request_, output);
        items.insert(items.end(), pinned.begin(), pinned.end());
        std::ranges::sort(items);
        const Vec2 corner = are_new_ ? Vec2{} : output.min;  // outputs of one size are alike for new items
        const Vec2 size = output.max - output.min;
        const auto [at, is_new] = made_.try_emplace({{corner.x, corner.y, size.x, size.y}, items});
        if (is_new) at->second = (*plan_)(request_on(*request_, output, items), *watch_);
        const Layout& made = at->second;
        for (std::size_t n = 0; n < items.size(); ++n)
            if (!has_pinned_place(request_->items[items[n]]))
                layout.placements[items[n]] = composed(made.placements[n], {1, output.min});
        for (LayoutGroup group : made.groups) {
            for (std::size_t& item : group.items)
                item = items[item];
            layout.groups.push_back(std::move(group));
        }
    }

  private:
    using Key = std::pair<std::array<double, 4>, std::vector<std::size_t>>;

    const PlanRequest* request_;
    const PlanWatch* watch_;
    const PlanFunction* plan_;
    bool are_new_;                // no item has a place
    std::map<Key, Layout> made_;  // by the output's corner and size and its items
};

/// The best of some ways to share the items out, by quick plans.
Sharing best_sharing(Sharing best, const PlanRequest& request, const PlanWatch& watch,
                     const PlanFunction& plan) {
    PlanRequest quick = request;
    const std::size_t many = std::max(few, request.items.size());
    quick.budget = std::max<std::int64_t>(1, request.budget * static_cast<std::int64_t>(few) /
                                                 (quick_share * static_cast<std::int64_t>(many)));
    OutputPlans plans(quick, watch, plan);
    Random random(request.seed);
    double least = cost_of_plan(quick, plans.planned_as(best));
    for (int k = 0; k < exchanges && !(watch.should_stop && watch.should_stop()); ++k) {
        Sharing next = best;
        next.disturb(random);
        const double cost = cost_of_plan(quick, plans.planned_as(next));
        if (cost >= least) continue;
        least = cost;
        best = std::move(next);
    }
    return best;
}

}  // namespace

Layout plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan) {
    return OutputPlans(request, watch, plan).planned_as(Sharing(request));
}

Layout best_plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan) {
    Sharing best(request);
    if (best.has_choice() && request.items.size() <= max_shared)
        best = best_sharing(best, request, watch, plan);
    return OutputPlans(request, watch, plan).planned_as(best);
}

std::optional<Layout> change_by_outputs(const PlanRequest& request, const PlanWatch& watch,
                                        const PlanFunction& plan) {
    const Sharing sharing(request);
    const std::vector<std::vector<std::size_t>> shared = sharing.items_of_outputs();
    Layout layout = kept_places(request);
    OutputPlans plans(request, watch, plan);
    for (std::size_t k = 0; k < shared.size(); ++k) {
        const Box& output = sharing.outputs()[k];
        const bool is_same = std::ranges::all_of(shared[k], [&](std::size_t i) {
            const PlanItem& item = request.items[i];
            if (!item.previous) return false;
            const Box box = bounding_box(placed_region(item.item, *item.previous));
            return intersection(box, output) == box;
        });
        if (is_same && unseen_part(request, layout, {output}) <= max_hole) continue;
        plans.add(output, shared[k], layout);
        if (unseen_part(request, layout, {output}) > max_hole) return std::nullopt;
    }
    layout.energy = 1 - covered_px(request, layout) / (request.canvas.x * request.canvas.y);
    return layout;
}

double unseen_share(const PlanRequest& request, const Layout& layout) {
    return unseen_part(request, layout, seen_parts(request.canvas));
}

double cost_of_plan(const PlanRequest& request, const Layout& layout) {
    double shown = 0;
    for (const Box& part : seen_parts(request.canvas))
        shown += part.area();
    const double unseen = request.fills ? unseen_share(request, layout) : 0;
    return emptiness * unseen - fullness * covered_px(request, layout) / shown + spread_cost(request, layout);
}

}  // namespace vitrine::player
