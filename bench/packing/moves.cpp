#include "bench/packing/bench.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/initial_packing.hpp"
#include "player/layout/pack/overlap.hpp"

#include <fmt/format.h>

namespace vitrine::player {

namespace {

struct MoveFigures {
    double evaluated_us = 0;  // move, areas, energy
    double full_us = 0;       // all anew
    int differing = 0;        // moves after which a bit of the areas differs from the full evaluation
};

std::vector<GridPolygon> packed_outlines(std::size_t n, Random& random) {
    const ScaledItems all = scaled(random_hulls(n, random));
    Contacts contacts(all.shapes, 0);
    contacts.set_scales(all.scales);
    const std::vector<Vec2> places =
        initial_packing(all.view(), contacts, bench_ratio, PackingOrder::as_given);
    std::vector<GridPolygon> outlines;
    for (std::size_t i = 0; i < n; ++i)
        outlines.push_back(snapped(transformed(all.shapes[i].outline, all.scales[i], places[i])));
    return outlines;
}

/// Random walks from a packing, up to `reach` px a step, so that shapes touch and overlap.
MoveFigures walk(std::size_t n, int reach, std::uint64_t seed) {
    constexpr int moves = 4000;
    Random random(seed);
    std::vector<GridPolygon> outlines = packed_outlines(n, random);
    UnionArea areas(outlines);
    std::vector<std::pair<std::size_t, GridPoint>> ways;
    for (int k = 0; k < moves; k += 2) {  // there and back, as a descent tries them
        const std::size_t item = uniform_index(random, n);
        const auto span = static_cast<std::size_t>(2 * reach + 1);
        const auto step = [&] { return (static_cast<int>(uniform_index(random, span)) - reach) * 256; };
        const GridPoint by{step(), step()};
        ways.push_back({item, by});
        ways.push_back({item, {-by.x, -by.y}});
    }
    double sum = 0;
    MoveFigures figures;
    double start = cpu_ms();
    for (const auto& [item, by] : ways) {
        areas.move(item, by);
        const Measure measure{areas.area(), areas.overlap(), areas.bounds()};
        sum += paper_energy(measure, bench_ratio) > 0 ? 1 : 0;
    }
    figures.evaluated_us = (cpu_ms() - start) * 1e3 / moves;
    start = cpu_ms();
    for (int k = 0; k < moves / 10; ++k)
        sum += UnionArea(outlines).area();
    figures.full_us = (cpu_ms() - start) * 1e3 / (moves / 10.0);
    for (const auto& [item, by] : ways) {
        areas.move(item, by);
        for (GridPoint& p : outlines[item])
            p = {p.x + by.x, p.y + by.y};
        const UnionArea fresh(outlines);
        if (fresh.area() != areas.area() || fresh.overlap() != areas.overlap()) ++figures.differing;
    }
    if (sum < 0) fmt::print("never\n");
    return figures;
}

}  // namespace

void print_moves() {
    fmt::print(
        "\nOne evaluated move: areas and eq. 3.4; unit steps as a descent does, and steps of up to 100 px "
        "that "
        "make overlaps\n| n | unit step us | 100 px us | full evaluation us | bits that differ in 8000 moves "
        "|\n|--|--|--|--|--|\n");
    for (const std::size_t n : {4, 8, 12, 16, 32, 64, 200}) {
        const MoveFigures unit = walk(n, 1, 1);
        const MoveFigures wide = walk(n, 100, 2);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {} |\n", n, unit.evaluated_us, wide.evaluated_us,
                   unit.full_us, unit.differing + wide.differing);
    }
}

}  // namespace vitrine::player
