// Measures the seams between cells, taut ones against exact ones of the same walls in the same run: vertices
// before rounding, area of regions that is lost, gaps and overlaps, CPU time.
//   seams_bench [INSTANCES [CATALOGUE [all|judged]]]
// On items like those of real media, or on the regions of a catalogue. Every second shot of the catalogue is
// kept back: with "judged" the walls are made of these, with "all" (the default) of the others.

#include "bench/packing/bench.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/layout/cells/seams.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

using namespace vitrine;
using namespace vitrine::player;

namespace {

Items every_second(const Items& all, std::size_t first) {
    Items some;
    for (std::size_t i = first; i < all.size(); i += 2)
        some.push_back(all[i]);
    return some;
}

Loops loops_of(const std::vector<Polygon>& polygons) {
    Loops loops;
    for (const Polygon& polygon : polygons)
        loops.push_back(to_grid(polygon));
    return loops;
}

/// Figures of all walls with one number of items, for one kind of seams.
struct Row {
    std::vector<std::size_t> bends;  // one for each seam between two items
    double ms = 0;
    double lost = 0;     // px^2 of regions outside of their cells
    double gap = 0;      // px^2 that belong to no cell
    double overlap = 0;  // px^2 that belong to two cells
    int unknown = 0;     // walls whose seams cannot be told
};

void add_wall(Row& row, const Items& items, const Layout& layout, const CellStyle& style) {
    const double start = cpu_ms();
    const std::vector<Cell> made = cells(items, layout, style);
    row.ms += cpu_ms() - start;
    const Box canvas{{0, 0}, layout.canvas};
    std::vector<Loops> areas;
    Loops all;
    double sum = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        areas.push_back(loops_of(made[i].parts));
        const Polygon region = clipped(placed_region(items[i], layout.placements[i]), canvas);
        row.lost += area_of(difference_of({to_grid(region)}, areas.back()));
    }
    for (const Cell& cell : made)
        areas.push_back(loops_of(cell.filler));
    for (const Loops& loops : areas) {
        sum += area_of(loops);
        all.insert(all.end(), loops.begin(), loops.end());
    }
    const double covered = area_of(union_of(all, {}));
    row.gap += canvas.area() - covered;
    row.overlap += sum - covered;
    const auto seams = seams_of(areas, canvas);
    if (!seams) ++row.unknown;
    for (std::size_t k = 0; seams && k < seams->size(); ++k)
        if ((*seams)[k].right < items.size()) row.bends.push_back(bends_of((*seams)[k]));
}

void print(std::size_t count, const char* name, Row row, double ratio) {
    if (row.bends.empty()) row.bends.push_back(0);
    std::sort(row.bends.begin(), row.bends.end());
    fmt::print("| {} | {} | {} | {} | {} | {:.6f} | {:.6f} | {:.6f} | {} | {:.2f} |\n", count, name,
               row.bends[row.bends.size() / 2], row.bends[row.bends.size() * 99 / 100], row.bends.back(),
               row.lost, row.gap, row.overlap, row.unknown, ratio);
    std::fflush(stdout);
}

void print_table(const Items& supply, int instances, const CellStyle& style) {
    fmt::print(
        "| n | seams | vertices, median | p99 | worst | regions lost px^2 | gaps px^2 | overlaps px^2 | "
        "walls unknown | CPU / exact |\n|--|--|--|--|--|--|--|--|--|--|\n");
    CellStyle taut = style;
    taut.is_taut = true;
    for (const std::size_t count : {2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24}) {
        Row exact;
        Row straight;
        for (int k = 1; k <= instances; ++k) {
            Random random(static_cast<std::uint64_t>(k));
            PlanRequest request{.canvas = bench_canvas, .seed = static_cast<std::uint64_t>(k)};
            for (std::size_t i = 0; i < count; ++i)
                request.items.push_back({.item = supply.empty()
                                                     ? random_item(random)
                                                     : supply[uniform_index(random, supply.size())]});
            const Layout layout = plan(request);
            add_wall(exact, items_of(request), layout, style);
            add_wall(straight, items_of(request), layout, taut);
        }
        print(count, "exact", exact, 1);
        print(count, "taut", straight, straight.ms / exact.ms);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int instances = argc > 1 ? std::atoi(argv[1]) : 20;
    const bool is_judged = argc > 3 && std::string_view(argv[3]) == "judged";
    const Items supply = every_second(argc > 2 ? regions_of(argv[2]) : Items{}, is_judged ? 1 : 0);
    if (argc > 2 && supply.empty()) {
        fmt::print(stderr, "no regions in '{}'\n", argv[2]);
        return 1;
    }
    print_table(supply, instances, {});
}
