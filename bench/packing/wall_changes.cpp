// Measures time and calm with which a wall follows changes, and the time and the gaps of its cells.
//   wall_changes [INSTANCES [CATALOGUE [edits|cells]]]
// On items like those of real media, or on the regions of a catalogue. Times are of the CPU, moves of the
// items that are not edited are in shares of the canvas' diagonal, shares are of the 16:9 screen covered by
// I-Regions.

#include "bench/packing/bench.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/layout/edit/make_way.hpp"
#include "player/layout/pack/energy.hpp"
#include "player/layout/plan/motion.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr Vec2 canvas{1920, 1080};
constexpr std::size_t counts[] = {6, 12, 24, 200};

/// Where the items of a wall come from.
class Supply {
  public:
    explicit Supply(Items real) : real_(std::move(real)) {}

    bool is_drawn() const { return real_.empty(); }

    LayoutItem next(Random& random) const {
        return real_.empty() ? random_item(random) : real_[uniform_index(random, real_.size())];
    }

    Items next(std::size_t count, Random& random) const {
        Items items;
        for (std::size_t i = 0; i < count; ++i)
            items.push_back(next(random));
        return items;
    }

  private:
    Items real_;
};

Layout planned(const Items& items, Vec2 size, std::uint64_t seed) {
    PlanRequest request{.canvas = size, .seed = seed};
    if (items.size() > 50) request.budget = 20'000;
    for (const LayoutItem& item : items)
        request.items.push_back({.item = item});
    return plan(request);
}

double share(const WallState& wall) {
    return 1 - layout_of(wall).energy;
}

std::vector<NamedItem> named(const Items& items) {
    std::vector<NamedItem> all;
    for (const LayoutItem& item : items)
        all.push_back({"", all.size(), item});
    return all;
}

/// The share of the screen that no picture reaches.
double background_of(const WallState& wall) {
    return 1 - plan_result(named(wall.items), layout_of(wall)).canvas_filled;
}

/// Sums over the instances of one edit.
struct Row {
    double ms = 0, max_ms = 0;
    double median = 0, worst = 0;  // moves of the others
    double before = 0, after = 0;
    double background = 0, most_background = 0;  // shares of the screen that no picture reaches afterwards
    int crossfades = 0;                          // changes without a way for the items to move
    int unsound = 0;
    int count = 0;
};

Vec2 place(const LayoutItem& item, const Placement& at) {
    return seat_of(item, at).centre;
}

/// @param others  pairs of the same item before and after
void add(Row& row, const WallState& before, const WallState& after, double ms,
         const std::vector<std::pair<std::size_t, std::size_t>>& others) {
    std::vector<double> moves;
    Items items;
    std::vector<Placement> from;
    std::vector<Placement> to;
    const Vec2 stretch{after.canvas.x / before.canvas.x, after.canvas.y / before.canvas.y};
    for (const auto& [i, j] : others) {
        const Vec2 was = place(before.items[i], before.placements[i]);
        const Vec2 expected{was.x * stretch.x, was.y * stretch.y};
        moves.push_back(length(place(after.items[j], after.placements[j]) - expected) / length(after.canvas));
        items.push_back(after.items[j]);
        from.push_back(before.placements[i]);
        to.push_back(after.placements[j]);
    }
    std::sort(moves.begin(), moves.end());
    row.ms += ms;
    row.max_ms = std::max(row.max_ms, ms);
    row.median += moves[moves.size() / 2];
    row.worst += moves.back();
    row.before += share(before);
    row.after += share(after);
    const double background = background_of(after);
    row.background += background;
    row.most_background = std::max(row.most_background, background);
    if (before.canvas == after.canvas && !motion_between(items, from, to, canvas)) ++row.crossfades;
    const Measure measure = measured(after.items, after.placements);
    if (measure.hidden != 0) ++row.unsound;
    ++row.count;
}

std::vector<std::pair<std::size_t, std::size_t>> others_than(std::size_t item, std::size_t count,
                                                             bool is_gone) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < count; ++i)
        if (i != item) pairs.emplace_back(i, is_gone && i > item ? i - 1 : i);
    return pairs;
}

using Rows = std::map<std::string, Row>;

/// A change of a wall in which all stay, as the player asks for it.
PlanRequest request_of(const WallState& wall, std::uint64_t seed) {
    PlanRequest request{.canvas = wall.canvas, .seed = seed};
    for (std::size_t i = 0; i < wall.items.size(); ++i)
        request.items.push_back({.item = wall.items[i], .previous = wall.placements[i]});
    return request;
}

WallState changed(const PlanRequest& request) {
    return wall_state(items_of(request), plan(request));
}

WallState replaced(const WallState& wall, std::size_t item, const LayoutItem& newcomer, std::uint64_t seed) {
    PlanRequest request = request_of(wall, seed);
    request.items[item] = {.item = newcomer, .seat = seat_of(wall.items[item], wall.placements[item])};
    return changed(request);
}

/// The wish of a finger that takes an item to a place.
Wish wish_at(const WallState& wall, std::size_t item, Vec2 to, bool is_let_go) {
    constexpr double lifted_size = 0.75;
    const Placement& home = wall.homes[item];
    return {
        .item = item,
        .at = {home.scale * lifted_size, to - (place(wall.items[item], home) - home.offset) * lifted_size},
        .is_let_go = is_let_go};
}

/// The edits of one wall, timed.
class TimedEdits {
  public:
    TimedEdits(Rows& rows, const WallState& wall) : rows_(rows), wall_(wall) {}

    /// @param but  the item that is edited; the moves of the others count
    void run(const std::string& name, std::size_t but, const std::function<WallState()>& edit,
             bool is_gone = false) {
        const double start = cpu_ms();
        const WallState after = edit();
        add(rows_[name], wall_, after, cpu_ms() - start, others_than(but, wall_.items.size(), is_gone));
    }

    /// Fifteen steps of a finger, then it lets go.
    void drag(std::size_t item, Vec2 to, const EditRules& rules) {
        constexpr int steps = 15;
        const Vec2 from = place(wall_.items[item], wall_.placements[item]);
        WallState now = wall_;
        for (int k = 1; k <= steps + 1; ++k) {
            const Vec2 finger = from + (to - from) * (std::min(k, steps) / double{steps});
            const double start = cpu_ms();
            const WallState next = made_way(now, std::vector{wish_at(wall_, item, finger, k > steps)}, rules);
            add(rows_[k > steps ? "drag, drop" : "drag, a step"], now, next, cpu_ms() - start,
                others_than(item, wall_.items.size(), false));
            now = next;
        }
    }

  private:
    Rows& rows_;             // outlives this
    const WallState& wall_;  // outlives this
};

void measure_edits(Rows& rows, const Supply& supply, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const Items items = supply.next(count, random);
    const WallState wall = wall_state(items, planned(items, canvas, seed));
    const std::size_t item = uniform_index(random, count);
    TimedEdits edits(rows, wall);
    const LayoutItem newcomer = supply.next(random);
    edits.run("insert", count, [&] {
        PlanRequest request = request_of(wall, seed);
        request.items.push_back({.item = newcomer});
        return changed(request);
    });
    const auto deleted = [&] {
        PlanRequest request = request_of(wall, seed);
        request.items.erase(request.items.begin() + static_cast<std::ptrdiff_t>(item));
        return changed(request);
    };
    edits.run("delete", item, deleted, true);
    edits.run("replace", item, [&] { return replaced(wall, item, newcomer, seed); });
    const double x = canvas.x * uniform(random);
    edits.drag(item, {x, canvas.y * uniform(random)}, {.seed = seed});
    WallState changing = wall;
    for (std::uint64_t k = 0; k < 30; ++k)
        changing = replaced(changing, uniform_index(random, count), supply.next(random), seed + k);
    const WallState anew = wall_state(changing.items, planned(changing.items, canvas, seed));
    add(rows["30 replaced, before: packed anew"], anew, changing, 0, others_than(count, count, false));
}

void edits_table(const Supply& supply, int instances) {
    fmt::print("| n | edit | CPU ms | most | median move % | worst move % | share before | after | "
               "background % mean | most | no way | overlaps |\n|--|--|--|--|--|--|--|--|--|--|--|--|\n");
    for (const std::size_t count : counts) {
        Rows rows;
        for (int k = 0; k < instances; ++k)
            measure_edits(rows, supply, count, static_cast<std::uint64_t>(k) + 1);
        for (const auto& [name, row] : rows) {
            const auto mean = [&, n = row.count](double sum) { return sum / n; };
            fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.2f} | {:.1f} | {:.3f} | {:.3f} | {:.2f} | {:.1f} | "
                       "{} of {} | {} |\n",
                       count, name, mean(row.ms), row.max_ms, 100 * mean(row.median), 100 * mean(row.worst),
                       mean(row.before), mean(row.after), 100 * mean(row.background),
                       100 * row.most_background, row.crossfades, row.count, row.unsound);
        }
        std::fflush(stdout);
    }
}

void cells_table(const Supply& supply, int instances) {
    fmt::print(
        "\n| canvas | n | cells ms | corners | regions lost px^2 | background % mean | most | share |\n"
        "|--|--|--|--|--|--|--|--|\n");
    for (const Vec2 size : {Vec2{1920, 1080}, Vec2{1080, 1920}, Vec2{1024, 768}})
        for (const std::size_t count : {3, 4, 6, 8, 12, 24}) {
            double ms = 0, lost = 0, background = 0, largest = 0, covered = 0;
            std::size_t corners = 0;
            for (int k = 0; k < instances; ++k) {
                Random random(static_cast<std::uint64_t>(k) + 1);
                const Items items = supply.next(count, random);
                const Layout layout = planned(items, size, static_cast<std::uint64_t>(k) + 1);
                const double start = cpu_ms();
                const std::vector<Cell> made = cells(items, layout);
                ms += cpu_ms() - start;
                for (const Cell& cell : made)
                    for (const Polygon& part : cell.parts)
                        corners += part.size();
                const PlanResult result = plan_result(named(items), layout);
                lost += (1 - result.region_visible) * (1 - layout.energy) * size.x * size.y;
                background += 1 - result.canvas_filled;
                largest = std::max(largest, 1 - result.canvas_filled);
                covered += 1 - layout.energy;
            }
            fmt::print("| {}x{} | {} | {:.2f} | {} | {:.3f} | {:.2f} | {:.1f} | {:.3f} |\n", size.x, size.y,
                       count, ms / instances, corners / static_cast<std::size_t>(instances), lost / instances,
                       100 * background / instances, 100 * largest, covered / instances);
            std::fflush(stdout);
        }
}

}  // namespace

int main(int argc, char** argv) {
    const int instances = argc > 1 ? std::atoi(argv[1]) : 10;
    const Supply supply(argc > 2 ? regions_of(argv[2]) : Items{});
    if (argc > 2 && supply.is_drawn()) {
        fmt::print(stderr, "no regions in '{}'\n", argv[2]);
        return 1;
    }
    const std::string only = argc > 3 ? argv[3] : "";
    if (only != "cells") edits_table(supply, instances);
    if (only != "edits") cells_table(supply, instances);
}
