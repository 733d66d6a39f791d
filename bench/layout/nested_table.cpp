// Measures walls of folders: the share of the screen that pictures fill, and that I-Regions cover.
//   nested_table [INSTANCES [CATALOGUE]]
// Each wall has so many folders of three to five shots, and for every six folders a loose file. The items are
// like those of real media, or the shots of a catalogue. The least share of a row is printed, too.

#include "player/layout/plan/plan.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/catalogue_items.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

PlanRequest wall_of(std::size_t folders, const std::vector<LayoutItem>& known, std::uint64_t seed) {
    Random random(seed);
    PlanRequest request{.canvas = {1920, 1080}, .seed = seed};
    const std::size_t shots = folders <= 8 ? 5 : folders <= 16 ? 4 : 3;
    const auto any = [&] {
        return known.empty() ? random_item(random) : known[uniform_index(random, known.size())];
    };
    for (std::size_t f = 0; f < folders; ++f)
        for (std::size_t k = 0; k < shots; ++k)
            request.items.push_back({.item = any(), .group = static_cast<int>(f)});
    for (std::size_t f = 0; f < folders / 6; ++f)
        request.items.push_back({.item = any()});
    return request;
}

struct Row {
    double filled = 0;
    double least = 1;
    double covered = 0;
    double seconds = 0;
};

Row measured_row(std::size_t folders, const std::vector<LayoutItem>& known, int instances) {
    Row row;
    for (int i = 0; i < instances; ++i) {
        const PlanRequest request = wall_of(folders, known, static_cast<std::uint64_t>(i + 1));
        const auto begin = std::chrono::steady_clock::now();
        const Layout layout = plan(request);
        row.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        std::vector<NamedItem> items;
        for (const PlanItem& item : request.items)
            items.push_back({.path = "item", .item = item.item});
        const PlanResult result = plan_result(items, layout, {.is_taut = true, .corner_radius = 24});
        row.filled += result.canvas_filled;
        row.least = std::min(row.least, result.canvas_filled);
        row.covered += 1 - layout.energy;
    }
    return {row.filled / instances, row.least, row.covered / instances, row.seconds / instances};
}

}  // namespace

int main(int argc, char** argv) {
    const int instances = argc > 1 ? std::atoi(argv[1]) : 10;
    const std::vector<LayoutItem> known = argc > 2 ? items_of_catalogue(argv[2]) : std::vector<LayoutItem>{};
    fmt::print("folders  filled   least  covered  seconds\n");
    for (const std::size_t folders : {2, 5, 12, 27}) {
        const Row row = measured_row(folders, known, instances);
        fmt::print("{:7}  {:.4f}  {:.4f}  {:.4f}  {:7.2f}\n", folders, row.filled, row.least, row.covered,
                   row.seconds);
    }
}
