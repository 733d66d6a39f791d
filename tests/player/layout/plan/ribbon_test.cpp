#include "player/layout/plan/ribbon.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const PlanRequest rules{.budget = 8'000, .most_scale = 4, .fills = false};

std::vector<LayoutItem> random_items(std::size_t count, Random& random) {
    std::vector<LayoutItem> items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(random_item(random));
    return items;
}

}  // namespace

TEST_CASE("a strip goes on to the right, free of overlap, and what is firm never moves again") {
    Random random(3);
    Strip strip{.screen = {1280, 720}};
    for (int k = 0; k < 5; ++k) {
        const std::size_t wanted = wanted_newcomers(strip, 5);
        CHECK(wanted == (k == 0 ? 10 : 5));
        const StripExtension next = extension(strip, random_items(wanted, random), rules);
        const Strip after = extended(strip, next, plan(next.request));
        CHECK(after.items.size() == strip.items.size() + wanted);
        CHECK(after.firm > strip.firm);
        CHECK(is_sound(after.items, {.canvas = {after.end, 720}, .placements = after.placements}, "strip"));
        for (std::size_t i = 0; i < strip.items.size(); ++i)
            if (seat_of(strip.items[i], strip.placements[i]).centre.x < strip.firm)
                CHECK(after.placements[i].offset.x == doctest::Approx(strip.placements[i].offset.x));
        strip = after;
    }
    CHECK(strip.end >= 6 * 1280);
}

TEST_CASE("nothing new is laid out in what is seen") {
    Random random(4);
    Strip strip{.screen = {1280, 720}};
    for (int k = 0; k < 3; ++k) {
        const StripExtension next = extension(strip, random_items(wanted_newcomers(strip, 4), random), rules);
        const double before = strip.firm;
        strip = extended(strip, next, plan(next.request));
        for (std::size_t i = strip.items.size() - next.newcomers.size(); i < strip.items.size(); ++i)
            CHECK(bounding_box(placed_region(strip.items[i], strip.placements[i])).min.x >= before - 640);
    }
}

TEST_CASE("a strip of a finite width holds all items") {
    Random random(5);
    const std::vector<LayoutItem> items = random_items(17, random);
    for (const double width : {1280.0, 3000.0, 6000.0}) {
        const Layout layout = strip_layout(items, {1280, 720}, width, rules);
        CHECK(layout.canvas == Vec2{width, 720});
        CHECK(is_sound(items, layout, "finite_strip"));
        CHECK(layout.energy < 0.75);
    }
}
