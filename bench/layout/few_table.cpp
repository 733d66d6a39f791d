// Measures walls of few items: the share of the screen that no picture reaches, beside the least that a
// search finds for the same items.
//   few_table [INSTANCES [CATALOGUE [all|judged [SEARCHED]]]]
// On items like those of real media, or on the shots of a catalogue. Every second shot of the catalogue is
// kept back: with "judged" the walls are made of these, with "all" (the default) of the others. The bound is
// searched for the first SEARCHED walls of each row (all): every division into rectangles by cuts on a grid,
// the best of each first cut annealed for a long time. Regions are whole, no item is below half of its fair
// area unless the planner's is smaller, and the limit of enlargement is that of the planner.

#include "bench/packing/bench.hpp"
#include "player/layout/pack/few_items.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/fair_shares.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

using namespace vitrine;
using namespace vitrine::player;

namespace {

struct NamedCanvas {
    const char* name = "";
    Vec2 size;  // px
};

constexpr std::array canvases{NamedCanvas{"16:9", {1920, 1080}}, NamedCanvas{"9:16", {1080, 1920}},
                              NamedCanvas{"4:3", {1440, 1080}}, NamedCanvas{"32:9", {3840, 1080}}};

/// The items that sets are drawn from.
struct Supply {
    Items wide, upright;
};

Supply supply_of(const Items& items) {
    Supply supply;
    for (const LayoutItem& item : items)
        (item.core.width() >= item.core.height() ? supply.wide : supply.upright).push_back(item);
    return supply;
}

const LayoutItem& any_of(const Items& items, Random& random) {
    return items[uniform_index(random, items.size())];
}

/// A set of wide, of upright or of both kinds of items.
Items set_of(const Supply& supply, std::string_view kind, std::size_t count, Random& random) {
    Items items;
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_upright =
            kind == "upright" || (kind == "mixed" && (i == 0 || (i > 1 && uniform(random) < 0.5)));
        items.push_back(any_of(is_upright ? supply.upright : supply.wide, random));
    }
    return items;
}

double empty_share(const Items& items, const Layout& layout) {
    std::vector<NamedItem> named;
    for (const LayoutItem& item : items)
        named.push_back({.path = {}, .item = item});
    return 1 - plan_result(std::move(named), layout).canvas_filled;
}

PackingProblem problem_for(const PlanRequest& request, const Items& items) {
    PackingProblem problem;
    const Vec2 edge{request.margin, request.margin};
    problem.field = {edge, request.canvas - edge};
    problem.clearance = request.clearance;
    for (const LayoutItem& item : items)
        problem.shapes.push_back(shape_of(item.region));
    for (const Shape& shape : problem.shapes)
        problem.limits.push_back(std::min({request.max_scale, problem.field.width() / shape.extent.width(),
                                           problem.field.height() / shape.extent.height()}));
    problem.pinned.assign(items.size(), false);
    problem.pinned_places.resize(items.size());
    return problem;
}

/// The least share of the canvas without a picture that the search finds.
double searched_share(const PlanRequest& request, const Items& items, const Layout& planned) {
    constexpr double mostly_emptiness = 40;
    constexpr double half_area = -0.34;  // ln(scale)
    PackingProblem problem = problem_for(request, items);
    FillingTargets targets = targets_for_few({.natural = natural_scales(items, problem.shapes)});
    targets.emptiness = mostly_emptiness;
    targets.fair_size = half_area;
    SizedArrangement known{{}, {}};
    for (std::size_t i = 0; i < items.size(); ++i) {
        targets.frames.push_back(moved(items[i].core, problem.shapes[i].centroid * -1));
        const Placement& at = planned.placements[i];
        known.places.push_back(problem.shapes[i].centroid * at.scale + at.offset);
        known.scales.push_back(at.scale);
    }
    std::vector<SizedArrangement> starts = best_rectangles(problem, targets, 16);
    starts.push_back(known);
    const double smallest =
        std::min(0.5, std::ranges::min(fair_shares(items, planned.placements, request.max_scale)));
    problem.scales = known.scales;
    double least = exact_unfilled_share(problem, targets.frames, {known.places, 1});
    Random random(1);
    for (const SizedArrangement& start : starts) {
        problem.scales = start.scales;
        SearchBudget unlimited(std::numeric_limits<std::int64_t>::max());
        const Arrangement end = fill_gaps(problem, targets, {start.places, 1}, random, unlimited);
        std::vector<Placement> placements;
        for (std::size_t i = 0; i < items.size(); ++i)
            placements.push_back({problem.scale(i, end.growth), {}});
        if (std::ranges::min(fair_shares(items, placements, request.max_scale)) < smallest) continue;
        least = std::min(least, exact_unfilled_share(problem, targets.frames, end));
    }
    return least;
}

/// Mean and largest of some values.
struct Figure {
    double sum = 0;
    double largest = 0;
    int count = 0;

    void add(double value) {
        sum += value;
        largest = std::max(largest, value);
        ++count;
    }

    std::string text() const {
        return fmt::format("{:.1f}, {:.1f}", 100 * sum / std::max(1, count), 100 * largest);
    }
};

struct FewRow {
    Figure empty, bound, above, regions;
    double smallest = 1;  // I-Region / its fair share
    double ms = 0;
};

struct FewOptions {
    int instances = 10;
    int searched = 10;
};

FewRow measured_row(const Supply& supply, std::string_view kind, std::size_t count, Vec2 canvas,
                    const FewOptions& options) {
    FewRow row;
    for (int k = 1; k <= options.instances; ++k) {
        Random random(static_cast<std::uint64_t>(k));
        const Items items = set_of(supply, kind, count, random);
        PlanRequest request{.canvas = canvas, .seed = static_cast<std::uint64_t>(k)};
        for (const LayoutItem& item : items)
            request.items.push_back({.item = item});
        const double start = cpu_ms();
        const Layout layout = plan(request);
        row.ms += (cpu_ms() - start) / options.instances;
        const double empty = empty_share(items, layout);
        row.empty.add(empty);
        row.regions.add(1 - layout.energy);
        const std::vector<double> shares = fair_shares(items, layout.placements, request.max_scale);
        row.smallest = std::min(row.smallest, std::ranges::min(shares));
        if (k > options.searched) continue;
        const double bound = searched_share(request, items, layout);
        row.bound.add(bound);
        row.above.add(empty - bound);
    }
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    FewOptions options;
    if (argc > 1) options.instances = options.searched = std::atoi(argv[1]);
    if (argc > 4) options.searched = std::atoi(argv[4]);
    Items all;
    if (argc > 2) all = regions_of(argv[2]);
    Random random(7);
    for (int i = 0; argc <= 2 && i < 60; ++i)
        all.push_back(random_item(random));
    const bool is_judged = argc > 3 && std::string_view(argv[3]) == "judged";
    Items kept;
    for (std::size_t i = is_judged ? 1 : 0; i < all.size(); i += 2)
        kept.push_back(all[i]);
    const Supply supply = supply_of(kept);
    if (supply.wide.empty() || supply.upright.empty()) {
        fmt::print(stderr, "wide and upright shots are needed\n");
        return 1;
    }
    fmt::print("{} wide, {} upright shots; shares of the screen in %: mean, worst\n"
               "| n | set | screen | no picture | bound | above it | I-Regions | smallest / fair | ms |\n"
               "|--|--|--|--|--|--|--|--|--|\n",
               supply.wide.size(), supply.upright.size());
    for (const std::size_t count : {2, 3, 4, 5})
        for (const char* kind : {"wide", "upright", "mixed"})
            for (const NamedCanvas& canvas : canvases) {
                const FewRow row = measured_row(supply, kind, count, canvas.size, options);
                fmt::print("| {} | {} | {} | {} | {} | {} | {:.1f} | {:.2f} | {:.0f} |\n", count, kind,
                           canvas.name, row.empty.text(), row.bound.text(), row.above.text(),
                           100 * row.regions.sum / row.regions.count, row.smallest, row.ms);
                std::fflush(stdout);
            }
}
