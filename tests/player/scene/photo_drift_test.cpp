#include "player/scene/photo_drift.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/transition_frame.hpp"
#include "tests/player/layout/cells/shown_frame.hpp"
#include "tests/player/scene/changing_wall.hpp"
#include "tests/player/scene/frame_faults.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

using Shots = std::vector<PlacedShot>;

constexpr Vec2 screen{960, 540};

/// Where a frame draws each shot; of a shot that it draws twice, the lower one.
std::map<SourceId, Placement> places(const Frame& frame) {
    std::map<SourceId, Placement> places;
    for (const DrawItem& item : frame.items)
        places.emplace(item.source, item.placement);
    return places;
}

/// The longest way between the places of a shot in two frames, over the shots of the first wall.
double longest_step(const Frame& a, const Frame& b, const Shots& wall) {
    const auto before = places(a);
    const auto after = places(b);
    double longest = 0;
    for (const PlacedShot& placed : wall) {
        const auto from = before.find(placed.shot.source);
        const auto to = after.find(placed.shot.source);
        if (from != before.end() && to != after.end())
            longest = std::max(longest, length(to->second.offset - from->second.offset));
    }
    return longest;
}

Shots without_drift(Shots wall) {
    for (PlacedShot& placed : wall)
        placed.drift = {};
    return wall;
}

/// A change of a wall whose photos drift.
struct DriftingChange {
    Shots shown;
    Shots next;

    explicit DriftingChange(std::uint64_t seed) {
        ChangingWall wall(screen, 5 + seed % 8, seed);
        shown = wall.shown();
        give_drifts(shown, {});
        next = seed % 3 == 0 ? wall.with_one_less() : wall.turned();
        give_drifts(next, shown);
    }
};

}  // namespace

TEST_CASE("no photo drifts under a bezel") {
    int held_back = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Shots wall = ChangingWall(screen, 3 + seed % 14, seed).shown();
        give_drifts(wall, {});
        const Shots free = wall;
        std::vector<Box> bands;  // one directly at the right of each region
        for (const PlacedShot& placed : wall) {
            const Box region = bounding_box(placed_region(placed.shot.item, placed.placement));
            bands.push_back({{region.max.x + 0.5, 0}, {region.max.x + 20, screen.y}});
        }
        for (std::size_t i = 0; i < wall.size(); ++i) {
            give_drifts({&wall[i], 1}, {}, {&bands[i], 1});
            const PhotoDrift& drift = wall[i].drift;
            CHECK(std::max(drift.from.x, drift.to.x) <= 0.5);
            const PhotoDrift& before = free[i].drift;
            if (std::max(before.from.x, before.to.x) > 0.5) ++held_back;
        }
    }
    CHECK(held_back > 10);
}

TEST_CASE("a drifting photo shows its region at any time, and no edge of its picture") {
    int drifting = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Shots wall = ChangingWall(screen, 3 + seed % 14, seed).shown();
        give_drifts(wall, {});
        for (const PlacedShot& placed : wall) {
            if (length(placed.drift.to - placed.drift.from) > 0) ++drifting;
            const Loops cell = grid_loops(placed.cell->parts);
            for (auto now = 0s; now < 60s; now += 4s) {
                CAPTURE(seed);
                CAPTURE(placed.shot.source);
                Placement at = placed.placement;
                at.offset = at.offset + drift_at(placed, now);
                const Loops region{to_grid(placed_region(placed.shot.item, at))};
                const Loops picture{to_grid(to_polygon(shown_frame(placed.shot.item, at, screen)))};
                CHECK(area_of(difference_of(region, cell)) < 1e-3);
                CHECK(area_of(difference_of(cell, picture)) < 1e-3);
            }
        }
    }
    CHECK(drifting > 20);
}

TEST_CASE("a photo drifts slowly, and films do not") {
    Shots wall = ChangingWall(screen, 8, 5).shown();
    wall[0].shot.kind = MediaKind::film;
    give_drifts(wall, {});
    CHECK(length(wall[0].drift.to - wall[0].drift.from) == 0);
    double farthest = 0;
    for (auto now = 0ms; now < 60s; now += 100ms) {
        const Frame before = standing_frame(screen, wall, now);
        const Frame after = standing_frame(screen, wall, now + 100ms);
        CHECK(longest_step(before, after, wall) < 0.5);
        farthest =
            std::max(farthest, longest_step(before, standing_frame(screen, without_drift(wall), now), wall));
    }
    CHECK(farthest > 2);
    CHECK(farthest < 60);
}

TEST_CASE("no photo jumps when a change begins, on the way, or when it ends") {
    const auto duration = 1000ms;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        const DriftingChange change(seed);
        const auto began = std::chrono::seconds(7 * seed);
        const Transition made = transition(screen, change.shown, change.next, {.duration = duration});
        const Transition plain = transition(screen, without_drift(change.shown), without_drift(change.next),
                                            {.duration = duration});
        const auto frame_of = [&](const Transition& one, std::chrono::nanoseconds passed) {
            return transition_frame(one, passed, {}, began + passed);
        };
        CHECK(longest_step(standing_frame(screen, change.shown, began), frame_of(made, 1ms), change.shown) <
              0.5);
        CHECK(longest_step(frame_of(made, duration - 1ms),
                           standing_frame(screen, change.next, began + duration), change.next) < 0.5);
        double before = 0;
        for (auto passed = 20ms; passed < duration; passed += 20ms) {
            const double away = longest_step(frame_of(made, passed), frame_of(plain, passed), change.shown);
            if (passed > 20ms) CHECK(std::abs(away - before) < 4);
            before = away;
        }
    }
}

TEST_CASE("a photo whose place and cell do not change drifts on while others change") {
    Shots shown = ChangingWall(screen, 8, 3).shown();
    give_drifts(shown, {});
    Shots next = shown;
    next[0].shot.source = 999;  // as large and with the same region as the one that it replaces
    give_drifts(next, shown);
    const Transition made = transition(screen, shown, next, {.duration = 1000ms});
    const auto drawn = places(transition_frame(made, 500ms, {}, 20s));
    double farthest = 0;
    for (const PlacedShot& placed : shown) {
        if (placed.shot.source == shown[0].shot.source) continue;
        const Vec2 drift = drift_at(placed, 20s);
        farthest = std::max(farthest, length(drift));
        CHECK(length(drawn.at(placed.shot.source).offset - placed.placement.offset - drift) < 1e-6);
    }
    CHECK(farthest > 1);
}
