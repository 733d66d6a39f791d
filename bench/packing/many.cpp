#include "bench/packing/bench.hpp"
#include "player/layout/pack/initial_packing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::player {

namespace {

/// From the request to the first layout that could be shown.
double first_layout_ms(const PlanRequest& request, Layout& first) {
    const double start = cpu_ms();
    double end = 0;
    plan(request, {.on_better =
                       [&](const Layout& layout) {
                           if (end == 0) first = layout;
                           if (end == 0) end = cpu_ms();
                       },
                   .should_stop = [&] { return end > 0; }});
    return end - start;
}

double edit_ms(PlanRequest request, const Layout& before, std::size_t kind, Random& random, Layout& after) {
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].previous = before.placements[i];
    const LayoutItem other = random_hulls(1, random)[0];
    if (kind == 0) {
        const Seat seat = seat_of(request.items[3].item, before.placements[3]);
        request.items[3] = {.item = other, .seat = seat};
    }
    if (kind == 1) request.items.push_back({.item = other});
    if (kind == 2) request.items.erase(request.items.begin() + 5);
    const double start = cpu_ms();
    after = plan(request);
    return cpu_ms() - start;
}

}  // namespace

void print_many() {
    constexpr int times = 5;
    fmt::print("\nMany items, random hulls, ms\n| n | initial packing | first layout, share | replace | "
               "insert | delete "
               "| share after them |\n|--|--|--|--|--|--|--|\n");
    for (const std::size_t n : {6, 8, 12, 24, 48, 100, 200}) {
        double packing = 0;
        double first = 0;
        double share = 0;
        double edits[3] = {};
        double edited_share = 0;
        for (int k = 1; k <= times; ++k) {
            Random random(static_cast<std::uint64_t>(k));
            const Items items = random_hulls(n, random);
            const ScaledItems all = scaled(items);
            const double start = cpu_ms();
            Contacts contacts(all.shapes, 0);
            contacts.set_scales(all.scales);
            initial_packing(all.view(), contacts, bench_ratio, PackingOrder::largest_first);
            packing += cpu_ms() - start;
            const PlanRequest request = request_for(items, static_cast<std::uint64_t>(k));
            Layout layout;
            first += first_layout_ms(request, layout);
            share += 1 - layout.energy;
            for (std::size_t kind = 0; kind < 3; ++kind) {
                Layout after;
                edits[kind] += edit_ms(request, layout, kind, random, after);
                edited_share += (1 - after.energy) / 3;
            }
        }
        fmt::print("| {} | {:.2f} | {:.2f}, {:.3f} | {:.1f} | {:.1f} | {:.1f} | {:.3f} |\n", n,
                   packing / times, first / times, share / times, edits[0] / times, edits[1] / times,
                   edits[2] / times, edited_share / times);
    }
}

}  // namespace vitrine::player
