#include "player/scene/transition.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/scene/wall_cells.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr Vec2 canvas{400, 200};
const TransitionStyle style{.crossfade = 700ms, .motion = 250ms};

PlacedShot shot(SourceId source, int slot, Vec2 offset, double scale = 1) {
    PlacedShot placed{.shot = {.source = source, .slot = slot, .picture = {100, 100}}};
    placed.shot.item = {.region = to_polygon({{30, 30}, {70, 70}}), .core = {{0, 0}, {100, 100}}};
    placed.placement = {scale, offset};
    return placed;
}

std::vector<PlacedShot> wall(std::vector<PlacedShot> shots) {
    give_cells(shots, canvas, {});
    return shots;
}

}  // namespace

TEST_CASE("a wall where only one shot changes fades") {
    const auto acts = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}),
                                 wall({shot(1, 0, {0, 0}), shot(3, 1, {100, 0})}), style);
    REQUIRE(acts.size() == 1);
    CHECK(duration_of(acts) == 700ms);
}

TEST_CASE("what stays moves first, then the new one fades in") {
    const auto last = wall({shot(1, 0, {0, 50}), shot(2, 1, {100, 0}), shot(3, 2, {200, 0})});
    const auto acts = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}), last, style);
    REQUIRE(acts.size() == 2);
    CHECK(acts[0].motion);
    CHECK(duration_of(acts) == 950ms);
    const Frame moving = transition_frame(canvas, {.acts = acts, .passed = 125ms}, {}, 0s);
    CHECK(moving.items.size() == 2);
    CHECK(moving.items[0].placement.offset.y == doctest::Approx(25));
    CHECK(moving.items[0].alpha == 1);
    const Frame fading = transition_frame(canvas, {.acts = acts, .passed = 600ms}, {}, 0s);
    CHECK(fading.items[0].placement == last[0].placement);
    CHECK(fading.items.back().source == 3);
    CHECK(fading.items.back().alpha == doctest::Approx(0.5));
}

TEST_CASE("what leaves without a successor fades out before the others take its room") {
    const auto acts = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}),
                                 wall({shot(1, 0, {100, 0}, 1.5)}), style);
    REQUIRE(acts.size() == 2);
    CHECK_FALSE(acts[0].motion);
    CHECK(acts[0].to.size() == 1);
    CHECK(acts[1].motion);
}

TEST_CASE("a slot's last shot makes room for what moves until its next one is there") {
    const auto acts = transition(canvas, wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})}),
                                 wall({shot(1, 0, {62, 0}), shot(3, 1, {150, 0})}), style);
    REQUIRE(acts.size() == 2);
    REQUIRE(acts[0].motion);
    CHECK(acts[1].from[1].placement.scale < 1);
    for (int k = 0; k <= 20; ++k) {
        const Frame frame = transition_frame(canvas, {.acts = acts, .passed = k * 12ms}, {}, 0s);
        std::vector<Placement> placements;
        std::vector<LayoutItem> items;
        for (const DrawItem& item : frame.items) {
            placements.push_back(item.placement);
            items.push_back(shot(1, 0, {}).shot.item);
        }
        CHECK(measured(items, placements).hidden == 0);
    }
}

TEST_CASE("where there is no way, or nothing shall move, all fades") {
    const auto first = wall({shot(1, 0, {0, 0}), shot(2, 1, {100, 0})});
    const auto last = wall({shot(1, 0, {200, 0}), shot(2, 1, {100, 0})});
    TransitionStyle still = style;
    still.motion = 0ms;
    CHECK(transition(canvas, first, last, still).size() == 1);
    CHECK_FALSE(transition(canvas, first, last, still)[0].motion);
    CHECK_FALSE(transition(canvas, {}, last, style)[0].motion);
}
