#include "bench/packing/bench.hpp"
#include "player/layout/pack/descent.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/initial_packing.hpp"

#include <fmt/format.h>

namespace vitrine::player {

namespace {

struct PaperRow {
    const char* name;
    std::size_t items;
    double initial_s;  // on a Core 2 Duo of 3.2 GHz
    double iterations;
    double stable_s;
};

constexpr PaperRow table_4_1[] = {{"Cartoon", 6, 0.071, 61, 3.605}, {"New Year", 8, 0.134, 107, 3.689}};

}  // namespace

void print_paper(int instances) {
    fmt::print("\nTable 4.1 of the paper, with its energy (eq. 3.4-3.7 in logarithms) and its descent; "
               "random hulls, "
               "means of {}\n| set | n | initial packing, paper s | ours s | until stable, paper | ours | an "
               "iteration, paper ms | ours ms | ln E before | after |\n|--|--|--|--|--|--|--|--|--|--|\n",
               instances);
    for (const PaperRow& row : table_4_1) {
        double initial_ms = 0;
        double stable_ms = 0;
        double steps = 0;
        double before = 0;
        double after = 0;
        for (int k = 1; k <= instances; ++k) {
            Random random(static_cast<std::uint64_t>(k));
            const ScaledItems all = scaled(random_hulls(row.items, random));
            double start = cpu_ms();
            Contacts contacts(all.shapes, 0);
            contacts.set_scales(all.scales);
            const std::vector<Vec2> packing =
                initial_packing(all.view(), contacts, bench_ratio, PackingOrder::as_given);
            initial_ms += cpu_ms() - start;
            start = cpu_ms();
            SearchBudget budget(100'000'000);
            const DescentResult end = descend(all.view(), packing, bench_ratio, random, budget);
            stable_ms += cpu_ms() - start;
            steps += static_cast<double>(end.steps);
            before += end.first_energy;
            after += end.last_energy;
        }
        const double count = instances;
        fmt::print(
            "| {} | {} | {:.3f} | {:.5f} | {:.0f} in {:.3f} s | {:.1f} in {:.4f} s | {:.1f} | {:.4f} | "
            "{:.1f} | {:.1f} |\n",
            row.name, row.items, row.initial_s, initial_ms / count / 1e3, row.iterations, row.stable_s,
            steps / count, stable_ms / count / 1e3, row.stable_s * 1e3 / row.iterations,
            steps > 0 ? stable_ms / steps : 0, before / count, after / count);
    }
}

}  // namespace vitrine::player
