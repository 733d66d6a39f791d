// Measures how calm and how full a wall stays while its shots take turns.
//   rotations CATALOGUE [ROTATIONS [SLOTS]]
// The wall of the scene with its planner, sources ready at once, nothing drawn. Moves are of the centroids of
// the shots that stay, in shares of the canvas' diagonal; `seen` is the share of the canvas covered by
// I-Regions, `filler` the share where nobody has pixels.

#include "base/state/catalogue.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/scene/wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr Vec2 canvas{1920, 1080};
constexpr auto frame = std::chrono::milliseconds(40);

Vec2 place(const PlacedShot& placed) {
    return seat_of(placed.shot.item, placed.placement).centre;
}

double mean(const std::vector<double>& values) {
    return values.empty()
               ? 0
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double at_share(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double seen_of(std::span<const PlacedShot> wall) {
    double sum = 0;
    for (const PlacedShot& placed : wall)
        sum += seat_of(placed.shot.item, placed.placement).area;
    return sum / (canvas.x * canvas.y);
}

double filler_of(std::span<const PlacedShot> wall) {
    double sum = 0;
    for (const PlacedShot& placed : wall)
        for (const Polygon& polygon : placed.cell->filler)
            sum += signed_area(polygon);
    return sum / (canvas.x * canvas.y);
}

/// The measures of some rotations.
struct Rotations {
    std::vector<double> medians, greatest, seen, filler;
    int anew = 0;  // in which most of the others moved far
};

void tell(const std::string& name, const Rotations& stretch) {
    fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {:.3f} | {:.3f} | {:.1f} | {:.1f} | {} |\n", name,
               100 * at_share(stretch.medians, 0.5), 100 * at_share(stretch.medians, 0.9),
               100 * mean(stretch.greatest), mean(stretch.seen), at_share(stretch.seen, 0.1),
               100 * mean(stretch.filler), 100 * at_share(stretch.filler, 0.9), stretch.anew);
    std::fflush(stdout);
}

void add(Rotations& stretch, std::span<const PlacedShot> before, std::span<const PlacedShot> after) {
    constexpr double far = 0.1;
    std::vector<double> moves;
    for (const PlacedShot& placed : after)
        for (const PlacedShot& old : before)
            if (old.shot.source == placed.shot.source)
                moves.push_back(length(place(placed) - place(old)) / length(canvas));
    if (moves.empty()) return;
    stretch.medians.push_back(at_share(moves, 0.5));
    stretch.greatest.push_back(at_share(moves, 1));
    stretch.seen.push_back(seen_of(after));
    stretch.filler.push_back(filler_of(after));
    if (stretch.medians.back() > far) ++stretch.anew;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "rotations CATALOGUE [ROTATIONS [SLOTS]]\n"), 1;
    const int rotations = argc > 2 ? std::atoi(argv[2]) : 200;
    const int slots = argc > 3 ? std::atoi(argv[3]) : 12;
    const int stretch_length = std::max(1, rotations / 5);
    const auto ignore = [](const std::string&, const std::string&) {};
    Wall wall(canvas, {.slots = {.count = slots}});
    const std::vector<MediaRecord> records = Catalogue(argv[1]).load(ignore);
    if (records.size() < 2) return std::fprintf(stderr, "no records to take turns\n"), 1;
    wall.set_catalogue(records);
    fmt::print(
        "{} slots, {} rotations\n\n| rotations | median move % | 90th | farthest | seen | 10th | filler "
        "% | 90th | anew |\n|--|--|--|--|--|--|--|--|--|\n",
        slots, rotations);
    Rotations all;
    Rotations stretch;
    std::vector<PlacedShot> before;
    int changes = 0;
    for (std::chrono::nanoseconds now{0}; changes < rotations; now += frame) {
        const WallStep step = wall.step(now);
        for (const ShotRequest& request : step.requests)
            wall.source_ready(request.source);
        if (step.plan) {
            PlanRequest request{.items = step.plan->items, .canvas = step.plan->canvas, .clearance = 2};
            Layout layout = plan(request);
            layout.generation = step.plan->generation;
            layout.is_final = true;
            wall.set_layout(layout);
        }
        const auto shown = wall.shown();
        const bool is_changed =
            !std::equal(shown.begin(), shown.end(), before.begin(), before.end(),
                        [](const auto& a, const auto& b) { return a.shot.source == b.shot.source; });
        if (!is_changed) continue;
        if (!before.empty()) {
            ++changes;
            add(all, before, shown);
            add(stretch, before, shown);
            if (changes % stretch_length == 0)
                tell(fmt::format("to {}", changes), std::exchange(stretch, {}));
        }
        before.assign(shown.begin(), shown.end());
    }
    tell("all", all);
}
