// How densely and how fast I-Regions are packed: the paper's way and ours, on the same instances.
//   packing [INSTANCES [CATALOGUE]]
// Random hulls, and the regions of a catalogue where one is given. Shares are of a 16:9 screen, means over
// the instances, times are of the CPU; the paper's own greedy and descent (eq. 3.4) run first, so every
// figure has its baseline.

#include "base/catalogue/catalogue.hpp"
#include "base/geometry/convex_hull.hpp"
#include "player/layout/cells.hpp"
#include "player/layout/descent.hpp"
#include "player/layout/effort.hpp"
#include "player/layout/energy.hpp"
#include "player/layout/initial_packing.hpp"
#include "player/layout/layout_item.hpp"
#include "player/layout/plan.hpp"
#include "player/layout/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace vitrine;

namespace {

using Items = std::vector<LayoutItem>;

constexpr Vec2 canvas{1920, 1080};
constexpr double ratio = canvas.x / canvas.y;

/// CPU time of this process, so that other programs do not count. Everything measured runs in one thread.
double cpu_ms() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double ms_since(double start) {
    return cpu_ms() - start;
}

/// The hull of 8 to 31 random points, sized within a factor of 4 of area.
LayoutItem random_hull(Random& random) {
    Polygon points;
    const std::size_t count = 8 + uniform_index(random, 24);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = uniform(random);
        points.push_back({x * 1000, uniform(random) * 1000});
    }
    LayoutItem item{.region = convex_hull(points)};
    const double side = std::sqrt(area(item.region) / std::pow(4.0, uniform(random))) * 100;
    item.core = {{0, 0}, {side, side}};  // only its area counts here
    return item;
}

Items random_hulls(std::size_t count, Random& random) {
    Items items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(random_hull(random));
    return items;
}

Items drawn(const Items& all, std::size_t count, Random& random) {
    Items items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(all[uniform_index(random, all.size())]);
    return items;
}

/// Sums over the instances of one row.
struct Row {
    double greedy_ms = 0, greedy = 0;       // the paper's initial packing and the share it covers
    double descent_ms = 0, descent = 0;     // eq. 3.4 descended from there
    double short_share = 0;                 // ours at 0.1 s
    double long_share = 0;                  // ours at 1 s
    double stable_ms = 0, stable = 0;       // ours with the default effort
    double filled_ms = 0, filled = 0;       // the same, giving way where filler would show
    double change_ms = 0, change_move = 0;  // one item replaced; median move of the others, of the diagonal
    double cells_ms = 0;
};

void measure_paper(Row& row, const Items& items, std::uint64_t seed) {
    std::vector<Shape> shapes;
    for (const LayoutItem& item : items)
        shapes.push_back(shape_of(item.region));
    std::vector<double> scales = natural_scales(items, shapes);
    double sum = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        sum += shapes[i].area * scales[i] * scales[i];
    const double area = 0.5 * canvas.x * canvas.y;  // so that a unit step is about a px of the canvas
    for (double& scale : scales)
        scale *= std::sqrt(area / sum);
    double start = cpu_ms();
    Contacts contacts(shapes, 0);
    contacts.set_scales(scales);
    const auto packing = initial_packing(shapes, contacts, scales, ratio, PackingOrder::as_given);
    row.greedy_ms += ms_since(start);
    row.greedy += area / screen_area(bounds_of(shapes, scales, packing), ratio);
    start = cpu_ms();
    Random random(seed);
    Effort effort(10'000'000);
    const auto places = descended(shapes, scales, packing, ratio, EnergyMode::paper, random, effort);
    row.descent_ms += ms_since(start);
    row.descent += area / screen_area(bounds_of(shapes, scales, places), ratio);
}

double share_within(PlanRequest request, double ms) {
    const double start = cpu_ms();
    request.budget = static_cast<std::int64_t>(ms * 8000);  // about what that time allows; the clock decides
    return 1 - plan(request, {.should_stop = [&] { return ms_since(start) >= ms; }}).energy;
}

void measure_change(Row& row, PlanRequest request, const Layout& before, const LayoutItem& newcomer) {
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].previous = before.placements[i];
    request.items[0] = {.item = newcomer, .seat = seat_of(request.items[0].item, before.placements[0])};
    const double start = cpu_ms();
    const Layout after = plan(request);
    row.change_ms += ms_since(start);
    std::vector<double> moves;
    for (std::size_t i = 1; i < request.items.size(); ++i) {
        const LayoutItem& item = request.items[i].item;
        const Vec2 from = seat_of(item, before.placements[i]).centre;
        moves.push_back(length(seat_of(item, after.placements[i]).centre - from));
    }
    std::sort(moves.begin(), moves.end());
    row.change_move += moves[moves.size() / 2] / length(canvas);
}

void measure(Row& row, const Items& items, const LayoutItem& newcomer, std::uint64_t seed) {
    measure_paper(row, items, seed);
    PlanRequest request{.canvas = canvas, .seed = seed, .most_scale = 100, .fills = false};
    for (const LayoutItem& item : items)
        request.items.push_back({.item = item});
    row.short_share += share_within(request, 100);
    row.long_share += share_within(request, 1000);
    double start = cpu_ms();
    const Layout layout = plan(request);
    row.stable_ms += ms_since(start);
    row.stable += 1 - layout.energy;
    request.fills = true;
    start = cpu_ms();
    row.filled += 1 - plan(request).energy;
    row.filled_ms += ms_since(start);
    measure_change(row, request, layout, newcomer);
    start = cpu_ms();
    cells(items, layout);
    row.cells_ms += ms_since(start);
}

void print(std::size_t n, const Row& row, int count) {
    const auto mean = [&](double sum) { return sum / count; };
    fmt::print("| {} | {:.2f} | {:.3f} | {:.1f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.3f} in {:.0f} | "
               "{:.3f} in {:.0f} "
               "| {:.0f} "
               "| {:.1f} % | {:.1f} |\n",
               n, mean(row.greedy_ms), mean(row.greedy), mean(row.descent_ms), mean(row.descent),
               mean(row.short_share), mean(row.long_share), row.long_share / row.descent, mean(row.stable),
               mean(row.stable_ms), mean(row.filled), mean(row.filled_ms), mean(row.change_ms),
               100 * mean(row.change_move), mean(row.cells_ms));
    std::fflush(stdout);
}

template <typename Draw> void table(const char* title, int instances, const Draw& draw) {
    fmt::print(
        "{}\n| n | greedy ms | share | paper descent ms | share | ours 0.1 s | 1 s | x | stable, ms "
        "| filled, ms | change ms | median move | cells ms |\n|--|--|--|--|--|--|--|--|--|--|--|--|--|\n",
        title);
    for (const std::size_t n : {4, 6, 8, 12, 24}) {
        Row row;
        for (int k = 0; k < instances; ++k) {
            const auto seed = static_cast<std::uint64_t>(k) + 1;
            Random random(seed);
            const Items items = draw(n, random);
            measure(row, items, draw(1, random)[0], seed);
        }
        print(n, row, instances);
    }
}

Items regions_of(const char* directory) {
    Items items;
    for (const MediaRecord& record : Catalogue(directory).load())
        if (record.state == MediaState::ready)
            for (const Shot& shot : record.shots)
                items.push_back(layout_item(record, shot));
    return items;
}

}  // namespace

int main(int argc, char** argv) {
    const int instances = argc > 1 ? std::atoi(argv[1]) : 10;
    table("random hulls", instances, random_hulls);
    if (argc <= 2) return 0;
    const Items all = regions_of(argv[2]);
    if (all.empty()) return 0;
    table("regions of the catalogue", instances,
          [&](std::size_t n, Random& random) { return drawn(all, n, random); });
}
