#include "bench/packing/bench.hpp"
#include "player/layout/pack/descent.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "tests/player/layout/inversions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace vitrine::player {

namespace {

/// Sums and spread over the instances of one figure.
class Figure {
  public:
    void add(double value) { values_.push_back(value); }

    double mean() const {
        double sum = 0;
        for (const double value : values_)
            sum += value;
        return sum / static_cast<double>(values_.size());
    }

    /// "mean (least - quarter - most)"
    std::string spread() const {
        std::vector<double> sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        return fmt::format("{:.3f} ({:.3f} {:.3f} {:.3f})", mean(), sorted.front(), sorted[sorted.size() / 4],
                           sorted.back());
    }

  private:
    std::vector<double> values_;
};

struct Row {
    Figure greedy_ms, greedy;    // the paper's initial packing and the share it covers
    Figure descent_ms, descent;  // eq. 3.4 descended from there
    Figure tenth, second;        // ours after 0.1 s and 1 s
    Figure usual_ms, usual;      // ours with the default budget
    Figure reading;              // ours after 1 s in strict order
    std::size_t inverted = 0;    // pairs
};

void measure_paper(Row& row, const Items& items, std::uint64_t seed) {
    const ScaledItems all = scaled(items);
    const auto share = [&](std::span<const Vec2> places) {
        return all.area / screen_area(bounds_of(all.view(), places), bench_ratio);
    };
    double start = cpu_ms();
    Contacts contacts(all.shapes, 0);
    contacts.set_scales(all.scales);
    const std::vector<Vec2> packing =
        initial_packing(all.view(), contacts, bench_ratio, PackingOrder::as_given);
    row.greedy_ms.add(cpu_ms() - start);
    row.greedy.add(share(packing));
    start = cpu_ms();
    Random random(seed);
    SearchBudget budget(10'000'000);
    const DescentResult end = descend(all.view(), packing, bench_ratio, random, budget);
    row.descent_ms.add(cpu_ms() - start);
    row.descent.add(share(end.places));
}

Layout plan_within(PlanRequest request, double ms) {
    const double start = cpu_ms();
    request.budget = std::numeric_limits<std::int64_t>::max();
    return plan(request, {.should_stop = [&] { return cpu_ms() - start >= ms; }});
}

void measure(Row& row, const Items& items, std::uint64_t seed, bool fills) {
    measure_paper(row, items, seed);
    PlanRequest request = request_for(items, seed);
    row.tenth.add(1 - plan_within(request, 100).energy);
    row.second.add(1 - plan_within(request, 1000).energy);
    request.fills = fills;
    const double start = cpu_ms();
    row.usual.add(1 - plan(request).energy);
    row.usual_ms.add(cpu_ms() - start);
    if (items.size() != 8) return;
    request.fills = false;
    request.order = LayoutOrder::reading;
    const Layout read = plan_within(request, 1000);
    row.reading.add(1 - read.energy);
    row.inverted += inversions_of(items, read);
}

void print(std::size_t n, const Row& row) {
    fmt::print("| {} | {:.3f} in {:.2f} | {:.3f} in {:.1f} | {} | {} | {:.2f} | {:.3f} in {:.0f} |", n,
               row.greedy.mean(), row.greedy_ms.mean(), row.descent.mean(), row.descent_ms.mean(),
               row.tenth.spread(), row.second.spread(), row.second.mean() / row.descent.mean(),
               row.usual.mean(), row.usual_ms.mean());
    if (n == 8) fmt::print(" {}, {} inversions |", row.reading.spread(), row.inverted);
    fmt::print("\n");
    std::fflush(stdout);
}

}  // namespace

void print_shares(const char* title, const Draw& draw, int instances, bool fills) {
    fmt::print(
        "\n{}: share of the screen covered by I-Regions, {} instances; mean (least, lower quarter, most)\n"
        "| n | paper's greedy, ms | + eq. 3.4 descended, ms | ours 0.1 s | ours 1 s | x paper | default "
        "budget{}, ms | reading order 1 s |\n|--|--|--|--|--|--|--|--|\n",
        title, instances, fills ? " and filled, as on the wall" : "");
    for (const std::size_t n : {4, 6, 8, 12, 24}) {
        Row row;
        for (int k = 1; k <= instances; ++k) {
            Random random(static_cast<std::uint64_t>(k));
            measure(row, draw(n, random), static_cast<std::uint64_t>(k), fills);
        }
        print(n, row);
    }
}

}  // namespace vitrine::player
