#include "player/layout/plan/plan_by_outputs.hpp"

#include "player/layout/pack/search_budget.hpp"
#include "player/layout/pack/shape.hpp"
#include "player/layout/plan/bands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr int samples = 48;                // of an output, across and down
constexpr std::size_t max_exchanged = 24;  // items; more fill outputs well however they are shared out
constexpr int exchanges = 24;              // of items between outputs that are tried
constexpr std::int64_t quick_share = 30;   // a try has this part of the budget
constexpr double emptiness = 3;            // costs of an area without pixels; see FillingTargets
constexpr double unevenness = 0.05;        // factor of the variance of ln(scale)
constexpr double tininess = 20;            // factor of the mean square of ln(scale) missing to a fair one
constexpr double fair_size = -0.15;        // ln(scale) relative to the natural one

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

    bool is_on(std::size_t item, std::size_t output) const { return output_of_[item] == output; }

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
            if (item.is_pinned && item.previous) continue;
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

/// The request of what one output shows. @param is_on  tells the items that are shared out to it
PlanRequest request_on(const PlanRequest& request, const Box& output, std::vector<std::size_t>& inside,
                       const std::function<bool(std::size_t)>& is_on) {
    PlanRequest part = request;
    part.canvas = Canvas(output.max - output.min);
    part.items.clear();
    const Placement shift{1, output.min * -1};
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        PlanItem item = request.items[i];
        const bool is_pinned = item.is_pinned && item.previous;
        const bool reaches_in =
            is_pinned &&
            !intersection(bounding_box(placed_region(item.item, *item.previous)), output).is_empty();
        if (!reaches_in && !(is_on(i) && !is_pinned)) continue;
        if (item.previous) item.previous = composed(*item.previous, shift);
        if (item.home) item.home = composed(*item.home, shift);
        if (item.seat) item.seat->centre = item.seat->centre - output.min;
        inside.push_back(i);
        part.items.push_back(std::move(item));
    }
    part.budget = std::max<std::int64_t>(
        1, request.budget * static_cast<std::int64_t>(inside.size()) /
               std::max<std::int64_t>(1, static_cast<std::int64_t>(request.items.size())));
    return part;
}

/// The parts of the canvas that are seen.
std::vector<Box> seen_parts(const Canvas& canvas) {
    return canvas.outputs.empty() ? std::vector<Box>{{{0, 0}, canvas}} : canvas.outputs;
}

/// The share of what is seen that no picture reaches, sampled.
double unseen_share(const PlanRequest& request, const Layout& layout) {
    std::vector<Box> pictures;
    for (std::size_t i = 0; i < request.items.size(); ++i)
        pictures.push_back(placed_core(request.items[i].item, layout.placements[i]));
    const std::vector<Box> parts = seen_parts(request.canvas);
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

Layout planned_as(const Sharing& sharing, const PlanRequest& request, const PlanWatch& watch,
                  const PlanFunction& plan) {
    Layout layout{.canvas = request.canvas, .placements = std::vector<Placement>(request.items.size())};
    for (std::size_t i = 0; i < request.items.size(); ++i)
        layout.placements[i] = request.items[i].previous.value_or(Placement{});
    for (std::size_t k = 0; k < sharing.outputs().size(); ++k) {
        const Box& output = sharing.outputs()[k];
        std::vector<std::size_t> inside;
        const PlanRequest part =
            request_on(request, output, inside, [&](std::size_t i) { return sharing.is_on(i, k); });
        const Layout made = plan(part, watch);
        for (std::size_t n = 0; n < inside.size(); ++n) {
            if (part.items[n].is_pinned && part.items[n].previous) continue;
            layout.placements[inside[n]] = composed(made.placements[n], {1, output.min});
        }
        for (LayoutGroup group : made.groups) {
            for (std::size_t& item : group.items)
                item = inside[item];
            layout.groups.push_back(std::move(group));
        }
    }
    layout.energy = 1 - covered_px(request, layout) / (request.canvas.x * request.canvas.y);
    return layout;
}

}  // namespace

Layout plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan) {
    return planned_as(Sharing(request), request, watch, plan);
}

Layout best_plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan) {
    Sharing best(request);
    if (!best.has_choice() || request.items.size() > max_exchanged)
        return planned_as(best, request, watch, plan);
    PlanRequest quick = request;
    quick.fills = false;
    quick.budget = std::max<std::int64_t>(1, request.budget / quick_share);
    Random random(request.seed);
    double least = cost_of_plan(quick, planned_as(best, quick, watch, plan));
    for (int k = 0; k < exchanges && !(watch.should_stop && watch.should_stop()); ++k) {
        Sharing next = best;
        next.disturb(random);
        const double cost = cost_of_plan(quick, planned_as(next, quick, watch, plan));
        if (cost >= least) continue;
        least = cost;
        best = std::move(next);
    }
    return planned_as(best, request, watch, plan);
}

double cost_of_plan(const PlanRequest& request, const Layout& layout) {
    double shown = 0;
    for (const Box& part : seen_parts(request.canvas))
        shown += part.area();
    const double unseen = request.fills ? unseen_share(request, layout) : 0;
    return emptiness * unseen - covered_px(request, layout) / shown + spread_cost(request, layout);
}

}  // namespace vitrine::player
