// Makes acts of a wall that is planned as the player plans, and tells what a box draws of acts: so that boxes
// with different libraries of mathematics can be compared.
//   act_frames make SEED   prints an act a line: turns, and shots in a hand
//   act_frames draw        reads such lines; prints nine moments of each act, a line each: the items with
//                          their places and the outlines of their cells, canvas px

#include "player/layout/plan/plan.hpp"
#include "player/scene/acts/act_json.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/scene/acts/shared_house.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr int slots = 8;
constexpr int moments = 8;  // parts of a change

/// Photos with regions of many forms.
std::vector<MediaRecord> drawn_records(std::uint64_t seed) {
    Random random(seed);
    std::vector<MediaRecord> records = photos(3 * slots);
    for (MediaRecord& record : records) {
        const LayoutItem item = random_item(random);
        record.width = static_cast<int>(item.core.width());
        record.height = static_cast<int>(item.core.height());
        record.shots[0].region.polygon = item.region;
    }
    return records;
}

Layout planned(const WallPlan& wall) {
    PlanRequest request{.items = wall.items, .canvas = wall.canvas, .budget = 20'000};
    request.keeps_places = wall.keeps_places;
    Layout layout = plan(request);
    layout.generation = wall.generation;
    layout.is_final = true;
    return layout;
}

/// Prints the act that the follower shows, if it is another one than before.
void print_new_act(SharedHouse& house, std::uint64_t& last) {
    const WallAct* const act = house.followed(1).shown();
    if (act == nullptr || act->name.generation == last) return;
    last = act->name.generation;
    fmt::print("{}\n", to_json(*act));
}

void make(std::uint64_t seed) {
    SharedHouse::Options options{.seed = seed, .followers = 1, .records = drawn_records(seed)};
    options.wall.slots = {.count = slots, .order = ShotOrder::name, .dwell = 3s};
    options.wall.transition.cells = {.is_taut = true, .gutter = 4, .corner_radius = 12};
    options.lay_out = planned;
    SharedHouse house(options);
    std::uint64_t last = 0;
    constexpr int lifts_at = 340;  // frames; no change is under way then
    constexpr int drag = 20;
    for (int k = 0; k < 700; ++k) {
        house.run(33ms);
        print_new_act(house, last);
        if (k < lifts_at || k >= lifts_at + drag) continue;
        const PlacedShot& shot = house.led().parts().shown.front();
        const Vec2 from = placed_region(shot.shot.item, shot.placement).front();
        const Vec2 way{13, 9};
        house.led().handle_gesture(
            {.kind = k + 1 < lifts_at + drag ? Gesture::Kind::drag : Gesture::Kind::drop,
             .touch = 1,
             .subject = shot.shot.source,
             .at = from + way * (k - lifts_at),
             .from = from,
             .moved = way});
    }
}

void print(const Polygon& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i)
        fmt::print("{}[{},{}]", i == 0 ? "" : ",", outline[i].x, outline[i].y);
}

void print(const Frame& frame) {
    fmt::print("[");
    for (const DrawItem& item : frame.items) {
        fmt::print("{}{{\"source\":{},\"alpha\":{},\"at\":[{},{},{}],\"cell\":[",
                   &item == &frame.items.front() ? "" : ",", item.source, item.alpha, item.placement.scale,
                   item.placement.offset.x, item.placement.offset.y);
        bool is_first = true;
        for (const auto* outlines : {&item.cell->parts, &item.cell->filler})
            for (const Polygon& outline : *outlines) {
                fmt::print("{}[", is_first ? "" : ",");
                print(outline);
                fmt::print("]");
                is_first = false;
            }
        fmt::print("]}}");
    }
    fmt::print("]\n");
}

/// The time that an act's change takes: a way, a transition, or the fade of the first wall.
Ns duration_of(const WallAct& act) {
    if (!act.change) return 0ns;
    if (act.change->way) return act.change->duration;
    return act.change->transition ? act.change->transition->duration : act.fade;
}

void draw() {
    for (std::string line; std::getline(std::cin, line);) {
        const WallAct act = act_from_json(line);
        const Ns began = act.change ? act.change->began : 1s;
        for (int k = 0; k <= moments; ++k)
            print(act_frame(act, began + duration_of(act) * k / moments));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view task = argc > 1 ? argv[1] : "";
    if (task == "make" && argc > 2)
        make(std::strtoull(argv[2], nullptr, 10));
    else if (task == "draw")
        draw();
    else
        return EXIT_FAILURE;
    return EXIT_SUCCESS;
}
