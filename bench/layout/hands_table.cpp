// Measures drags of a shot over a wall, and the time of the edits on their thread.
//   hands_table [COUNT [DRAGS]]
// On items like those of real media. Each drag takes a random shot in 8 steps to a random place and lets go
// there. Printed are the ways of the other shots from their places before the drag, as shares of the canvas'
// diagonal, at any step and at the end, and how far from the finger a shot is put down.

#include "player/layout/edit/make_way.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr double lifted_size = 0.75;  // as in scene/hands
constexpr int steps = 8;

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Vec2 place_of(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

Placement about(const LayoutItem& item, const Placement& at, Vec2 place, double scale) {
    return {scale, place - (place_of(item, at) - at.offset) * (scale / at.scale)};
}

struct Table {
    std::vector<double> any_step;  // the largest way of an other shot in a drag
    std::vector<double> at_end;    // ways of all others
    std::vector<double> missed;    // ways from the finger to where the shot was put
    std::vector<double> edit_ms;
    std::vector<double> seen;  // share of what was seen before
    int far = 0;               // others that moved more than a quarter of the diagonal
};

WallState edited(const WallState& wall, const Wish& wish, const EditRules& rules, Table& table) {
    const auto begin = std::chrono::steady_clock::now();
    WallState next = made_way(wall, std::vector{wish}, rules);
    table.edit_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    return next;
}

void drag_one(WallState wall, Random& random, Table& table) {
    const EditRules rules{.budget = 30'000, .max_scale = 4};
    const double diagonal = length(wall.canvas);
    const std::size_t held = uniform_index(random, wall.items.size());
    const LayoutItem& item = wall.items[held];
    const Placement home = wall.homes[held];
    const Vec2 from = place_of(item, home);
    const Vec2 to{wall.canvas.x * uniform(random), wall.canvas.y * uniform(random)};
    const WallState before = wall;
    const auto way = [&](std::size_t i, const WallState& after) {
        return length(place_of(wall.items[i], after.placements[i]) -
                      place_of(wall.items[i], before.placements[i])) /
               diagonal;
    };
    double most = 0;
    for (int k = 1; k <= steps + 1; ++k) {
        const Vec2 place = from + (to - from) * (std::min(k, steps) / double{steps});
        const WallState next =
            edited(wall, {held, about(item, home, place, home.scale * lifted_size), k > steps}, rules, table);
        wall.placements = next.placements;
        wall.homes = next.homes;
        for (std::size_t i = 0; i < wall.items.size(); ++i) {
            if (i == held) continue;
            most = std::max(most, way(i, wall));
            if (k > steps) table.at_end.push_back(way(i, wall));
            if (way(i, wall) > 0.25) ++table.far;
        }
    }
    table.any_step.push_back(most);
    table.missed.push_back(length(place_of(item, wall.placements[held]) - to) / diagonal);
    table.seen.push_back((1 - layout_of(wall).energy) / (1 - layout_of(before).energy));
}

}  // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? static_cast<std::size_t>(std::atoi(argv[1])) : 12;
    const int drags = argc > 2 ? std::atoi(argv[2]) : 200;
    Table table;
    Random random(1);
    for (int k = 0; k < drags;) {
        const PlanRequest request = random_request(count, static_cast<std::uint64_t>(k + 1));
        const WallState wall = wall_state(items_of(request), plan(request));
        for (int i = 0; i < 10 && k < drags; ++i, ++k)
            drag_one(wall, random, table);
    }
    fmt::print("{} shots, {} drags: {} ways of others beyond .25 of the diagonal\n", count, drags, table.far);
    fmt::print("others, of the diagonal: at the end median {:.4f}, 95 % {:.3f}, most {:.3f}; at any step "
               "most {:.3f}\n",
               quantile(table.at_end, 0.5), quantile(table.at_end, 0.95), quantile(table.at_end, 1),
               quantile(table.any_step, 1));
    fmt::print("from the finger to the shot: median {:.3f}, 95 % {:.3f}\n", quantile(table.missed, 0.5),
               quantile(table.missed, 0.95));
    fmt::print("seen after, of before: median {:.3f}, 5 % {:.3f}\n", quantile(table.seen, 0.5),
               quantile(table.seen, 0.05));
    fmt::print("an edit: median {:.1f} ms, 95 % {:.1f} ms\n", quantile(table.edit_ms, 0.5),
               quantile(table.edit_ms, 0.95));
    return 0;
}
