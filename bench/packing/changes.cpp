#include "bench/packing/bench.hpp"
#include "player/layout/cells/cells.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine::player {

namespace {

struct Sums {
    double change_ms = 0;
    double move = 0;  // median of the others, of the diagonal
    double cells_ms = 0;
};

void measure(Sums& sums, const Items& items, const LayoutItem& newcomer, std::uint64_t seed) {
    PlanRequest request = request_for(items, seed);
    const Layout before = plan(request);
    for (std::size_t i = 0; i < items.size(); ++i)
        request.items[i].previous = before.placements[i];
    request.items[0] = {.item = newcomer, .seat = seat_of(items[0], before.placements[0])};
    double start = cpu_ms();
    const Layout after = plan(request);
    sums.change_ms += cpu_ms() - start;
    std::vector<double> moves;
    for (std::size_t i = 1; i < items.size(); ++i)
        moves.push_back(length(seat_of(items[i], after.placements[i]).centre -
                               seat_of(items[i], before.placements[i]).centre));
    std::sort(moves.begin(), moves.end());
    sums.move += moves[moves.size() / 2] / length(bench_canvas);
    start = cpu_ms();
    cells(items, before);
    sums.cells_ms += cpu_ms() - start;
}

}  // namespace

void print_changes(int instances) {
    fmt::print(
        "\nOne item replaced in a finished layout, means of {}\n| n | until stable ms | median move of the "
        "others | exact cells ms |\n|--|--|--|--|\n",
        instances);
    for (const std::size_t n : {4, 6, 8, 12, 24}) {
        Sums sums;
        for (int k = 1; k <= instances; ++k) {
            Random random(static_cast<std::uint64_t>(k));
            const Items items = random_hulls(n, random);
            measure(sums, items, random_hulls(1, random)[0], static_cast<std::uint64_t>(k));
        }
        fmt::print("| {} | {:.1f} | {:.2f} % | {:.1f} |\n", n, sums.change_ms / instances,
                   100 * sums.move / instances, sums.cells_ms / instances);
    }
}

}  // namespace vitrine::player
