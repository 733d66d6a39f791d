#include "player/layout/plan/kept_layout.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"

#include <doctest/doctest.h>

#include <cstddef>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// A wall that was planned once and shall be so again. @param groups  false: all stand alone
PlanRequest placed_request(std::uint64_t seed, bool groups) {
    Random random(seed);
    PlanRequest request{.canvas = {1280, 720}, .seed = seed, .budget = 30'000};
    for (int i = 0; i < 12; ++i)
        request.items.push_back({.item = random_item(random), .group = groups ? i / 4 : PlanItem::no_group});
    const Layout layout = plan(request);
    for (std::size_t i = 0; i < request.items.size(); ++i)
        request.items[i].previous = layout.placements[i];
    request.keeps_places = true;
    return request;
}

}  // namespace

TEST_CASE("sound places are the layout, to the last bit") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const PlanRequest request = placed_request(seed, seed % 2 == 0);
        const Layout layout = plan(request);
        for (std::size_t i = 0; i < request.items.size(); ++i)
            CHECK(layout.placements[i] == *request.items[i].previous);
        CHECK(layout.groups.size() == (seed % 2 == 0 ? 3U : 0U));
        CHECK(layout.energy > 0);
        CHECK(layout.energy < 0.6);
    }
}

TEST_CASE("places that overlap, leave the canvas, are missing or are not to be kept are no layout") {
    PlanRequest request = placed_request(1, false);
    REQUIRE(kept_layout(request));
    PlanRequest other = request;
    other.keeps_places = false;
    CHECK_FALSE(kept_layout(other));
    other = request;
    other.items[3].previous.reset();
    CHECK_FALSE(kept_layout(other));
    other = request;
    other.items[3].previous->scale *= 1.3;
    CHECK_FALSE(kept_layout(other));
    other = request;
    other.items[3].previous->offset.x -= 2000;
    CHECK_FALSE(kept_layout(other));
    other = request;
    other.canvas = canvas_of(request.canvas, {{{0, 0}, {630, 720}}, {{650, 0}, {1280, 720}}});
    CHECK_FALSE(kept_layout(other));
}
