// Measures new walls on which like shots stand beside each other (layout.neighbours), against any neighbours.
//   neighbours_table [WALLS [CATALOGUE]]
// Shots are drawn at random from a catalogue; without one they are made-up items of six colours. A row tells
// the share of the screen under I-Regions and the mean difference of the colours of neighbours, of both.

#include "base/state/catalogue.hpp"
#include "player/layout/plan/neighbours.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// The shots of a catalogue's ready media, by their colours alone.
std::vector<PlanItem> shots_of(const char* directory) {
    std::vector<PlanItem> items;
    for (const MediaRecord& record : Catalogue(directory).load())
        if (record.state == MediaState::ready)
            for (const Shot& shot : record.shots)
                if (shot.look) items.push_back({.item = layout_item(record, shot), .look = shot.look});
    return items;
}

std::vector<PlanItem> made_shots() {
    Random random(1);
    std::vector<PlanItem> items;
    for (int i = 0; i < 60; ++i) {
        ShotLook look;
        for (std::size_t k = 0; k < look.colours.size(); ++k)
            look.colours[k] = static_cast<std::uint8_t>((i % 6 * 90 + static_cast<int>(k % 3) * 70) % 220 +
                                                        static_cast<int>(random() % 36));
        items.push_back({.item = random_item(random), .look = look});
    }
    return items;
}

struct Sums {
    double covered = 0, unlike = 0, seconds = 0;
};

void add_wall(Sums& sums, const PlanRequest& request) {
    const auto begin = std::chrono::steady_clock::now();
    const Layout layout = plan(request);
    sums.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    sums.covered += 1 - layout.energy;
    sums.unlike += mean_unlikeness(request, layout);
}

}  // namespace

int main(int argc, char** argv) {
    const int walls = argc > 1 ? std::atoi(argv[1]) : 10;
    const std::vector<PlanItem> known = argc > 2 ? shots_of(argv[2]) : made_shots();
    fmt::print("{} shots, {} walls a row\nshots  covered: any  alike  ratio   unlike: any  alike  ratio   "
               "seconds: any  alike  worst covered\n",
               known.size(), walls);
    for (const std::size_t count : {6, 12, 24, 48}) {
        if (count > known.size()) break;
        Sums any, alike;
        double worst = 1;
        for (int wall = 0; wall < walls; ++wall) {
            std::vector<PlanItem> drawn = known;
            Random random(static_cast<std::uint64_t>(wall) + 1);
            std::shuffle(drawn.begin(), drawn.end(), random);
            drawn.resize(count);
            PlanRequest request{
                .items = drawn, .canvas = {1920, 1080}, .seed = static_cast<std::uint64_t>(wall) + 1};
            const Sums before_any = any, before_alike = alike;
            add_wall(any, request);
            request.neighbours = NeighbourChoice::alike;
            add_wall(alike, request);
            worst =
                std::min(worst, (alike.covered - before_alike.covered) / (any.covered - before_any.covered));
        }
        fmt::print(
            "{:5}  {:12.3f}  {:5.3f}  {:5.3f}  {:12.3f}  {:5.3f}  {:5.3f}  {:13.2f}  {:5.2f}  {:13.3f}\n",
            count, any.covered / walls, alike.covered / walls, alike.covered / any.covered,
            any.unlike / walls, alike.unlike / walls, alike.unlike / any.unlike, any.seconds / walls,
            alike.seconds / walls, worst);
    }
}
