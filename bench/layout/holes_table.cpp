// Measures what no picture reaches after turns: a newcomer takes a shot's seat, the others move little.
//   holes_table [WALLS [CATALOGUE [COUNT...]]]
// On items like those of real media, or on the shots of a catalogue; ten turns a wall. Shares of the canvas
// in %: the mean, the 90th percentile and the most. Beside them stands by how much they are above a plan in
// which all the same items may go anywhere, and the way of the others.

#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/catalogue_items.hpp"
#include "tests/player/scene/changing_wall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace vitrine;
using namespace vitrine::player;

namespace {

constexpr int turns_a_wall = 10;
constexpr std::int64_t budget = 600'000;  // of the player's plans

/// The share of the canvas that no picture reaches.
double empty_share(const ChangingWall::Shots& shots, const Layout& layout) {
    std::vector<NamedItem> named;
    for (const PlacedShot& placed : shots)
        named.push_back({.path = {}, .item = placed.shot.item});
    return 1 - plan_result(std::move(named), layout).canvas_filled;
}

double empty_share(const ChangingWall::Shots& shots, Vec2 canvas) {
    Layout layout{.canvas = canvas};
    for (const PlacedShot& placed : shots)
        layout.placements.push_back(placed.placement);
    return empty_share(shots, layout);
}

double empty_share_of_fresh_plan(const ChangingWall::Shots& shots, Vec2 canvas) {
    PlanRequest request{.canvas = canvas};
    for (const PlacedShot& placed : shots)
        request.items.push_back({.item = placed.shot.item});
    return empty_share(shots, plan(request));
}

Vec2 middle_of(const PlacedShot& placed) {
    return bounding_box(placed_region(placed.shot.item, placed.placement)).centre();
}

/// The mean way of the shots that stay, share of the diagonal.
double mean_way(const ChangingWall::Shots& before, const ChangingWall::Shots& after, Vec2 canvas) {
    double sum = 0, count = 0;
    for (const PlacedShot& placed : after)
        for (const PlacedShot& old : before) {
            if (old.shot.source != placed.shot.source) continue;
            sum += length(middle_of(placed) - middle_of(old)) / length(canvas);
            count += 1;
        }
    return count > 0 ? sum / count : 0;
}

std::string in_percent(std::vector<double> shares) {
    std::ranges::sort(shares);
    double mean = 0;
    for (const double share : shares)
        mean += share / static_cast<double>(shares.size());
    return fmt::format("{:.2f}, {:.2f}, {:.2f}", 100 * mean, 100 * shares[shares.size() * 9 / 10],
                       100 * shares.back());
}

void print_row(std::size_t count, Vec2 canvas, int walls, const DrawItems& draw) {
    std::vector<double> empty, above, ways;
    double ms = 0;
    for (int wall_number = 1; wall_number <= walls; ++wall_number) {
        ChangingWall wall(canvas, count, static_cast<std::uint64_t>(wall_number), draw, {}, budget);
        for (int turn = 0; turn < turns_a_wall; ++turn) {
            const std::clock_t begin = std::clock();
            ChangingWall::Shots next = wall.turned();
            ms += 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / walls / turns_a_wall;
            empty.push_back(empty_share(next, canvas));
            above.push_back(empty.back() - empty_share_of_fresh_plan(next, canvas));
            ways.push_back(mean_way(wall.shown(), next, canvas));
            wall.show(std::move(next));
        }
    }
    fmt::print("| {} | {} x {} | {} | {} | {} | {:.0f} |\n", count, canvas.x, canvas.y, in_percent(empty),
               in_percent(above), in_percent(ways), ms);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int walls = argc > 1 ? std::max(1, std::atoi(argv[1])) : 6;
    std::vector<LayoutItem> known;
    if (argc > 2) known = items_of_catalogue(argv[2]);
    const DrawItems draw = [&](Random& random) {
        return known.empty() ? random_item(random) : known[uniform_index(random, known.size())];
    };
    std::vector<std::size_t> counts{3, 4, 5, 6, 8, 10, 12, 16};
    if (argc > 3) counts.clear();
    for (int i = 3; i < argc; ++i)
        counts.push_back(static_cast<std::size_t>(std::atoi(argv[i])));
    fmt::print(
        "| n | canvas | no picture | above a plan of all | way of the others | ms |\n|--|--|--|--|--|--|\n");
    for (const Vec2 canvas : {Vec2{960, 540}, Vec2{1920, 1080}, Vec2{1080, 1920}})
        for (const std::size_t count : counts)
            print_row(count, canvas, walls, draw);
}
