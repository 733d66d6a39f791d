// Measures the main thread's CPU time of a wall's frames while a finger drags a shot.
//   hands_frame [FRAMES]
// Walls of 12 and 200 shots like those of real media. The layouts are made outside of the measured time, as
// on the planner's thread. A frame is the gesture and Wall::step(), without drawing.

#include "base/geometry/vec2.hpp"
#include "player/layout/edit/wall_way.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/scene/wall.hpp"
#include "tests/player/layout/instances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{1920, 1080};

double thread_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

std::vector<MediaRecord> photos(std::size_t count) {
    Random random(3);
    std::vector<MediaRecord> records;
    for (std::size_t i = 0; i < count; ++i) {
        const LayoutItem item = random_item(random);
        records.push_back({.path = fmt::format("{:03}.jpg", i),
                           .kind = MediaKind::photo,
                           .bytes = 1000,
                           .mtime_ns = 1,
                           .state = MediaState::ready,
                           .width = static_cast<int>(item.core.max.x),
                           .height = static_cast<int>(item.core.max.y),
                           .shots = {{.region = {.polygon = item.region, .drift = {}}}}});
    }
    return records;
}

Layout layout_of(const WallPlan& wanted) {
    Layout layout;
    if (wanted.way) {
        auto way = std::make_shared<const WallWay>(way_to(*wanted.way));
        layout = {.canvas = wanted.canvas, .placements = way->keys.back().placements};
        layout.way = std::move(way);
    } else {
        PlanRequest request{.canvas = wanted.canvas, .budget = 60'000, .max_scale = 4};
        request.items = wanted.items;
        layout = plan(request);
    }
    layout.generation = wanted.generation;
    layout.is_final = true;
    return layout;
}

/// One frame; @return its CPU time in ms. The layout that it asks for comes before the next one.
double step(Wall& wall, std::chrono::nanoseconds& now, const std::optional<Gesture>& gesture) {
    const double begin = thread_ms();
    if (gesture) wall.handle_gesture(*gesture);
    const WallStep step = wall.step(now);
    double spent = thread_ms() - begin;
    for (const ShotRequest& request : step.requests)
        wall.source_ready(request.source);
    if (step.plan) {
        const Layout layout = layout_of(*step.plan);
        const double taken = thread_ms();
        wall.set_layout(layout);
        spent += thread_ms() - taken;
    }
    now += 16667us;
    return spent;
}

void measure(std::size_t count, int frames) {
    Wall wall(canvas, {.slots = {.count = static_cast<int>(count)}});
    wall.set_catalogue(photos(count));
    std::chrono::nanoseconds now{0};
    for (int k = 0; k < 240; ++k)
        step(wall, now, std::nullopt);
    const Vec2 from = canvas * 0.4;
    const auto shot = wall.shot_at(from);
    Gesture gesture{
        .kind = Gesture::Kind::drag, .touch = 1, .subject = shot->source, .at = from, .from = from};
    std::vector<double> spent;
    for (int k = 0; k < frames; ++k) {
        gesture.moved = Vec2{k % 120 < 60 ? 8.0 : -8.0, k % 60 < 30 ? 4.0 : -4.0};
        gesture.at = gesture.at + gesture.moved;
        spent.push_back(step(wall, now, gesture));
    }
    std::ranges::sort(spent);
    const auto at = [&](double share) {
        return spent[static_cast<std::size_t>(share * static_cast<double>(spent.size() - 1))];
    };
    const std::size_t drawn = wall.step(now).frame.items.size();
    fmt::print("{:3} shots, {} pictures: a frame median {:.3f} ms, 95 % {:.2f} ms, most {:.2f} ms\n", count,
               drawn, at(0.5), at(0.95), at(1));
}

}  // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 300;
    for (const std::size_t count : {12, 200})
        measure(count, frames);
    return 0;
}
