#include "player/layout/plan/ribbon.hpp"

#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace vitrine::player;

namespace {

const PlanRequest rules{.budget = 8'000, .max_scale = 4, .fills = false};

std::vector<LayoutItem> random_items(std::size_t count, Random& random) {
    std::vector<LayoutItem> items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(random_item(random));
    return items;
}

}  // namespace

TEST_CASE("a ribbon goes on to the right, free of overlap, and what is firm never moves again") {
    Random random(3);
    Ribbon ribbon{.screen = {1280, 720}};
    for (int k = 0; k < 5; ++k) {
        const std::size_t wanted = wanted_newcomers(ribbon, 5);
        CHECK(wanted == (k == 0 ? 10 : 5));
        const RibbonExtension next = extension(ribbon, random_items(wanted, random), rules);
        const Ribbon after = extended(ribbon, next, plan(next.request));
        CHECK(after.items.size() == ribbon.items.size() + wanted);
        CHECK(after.firm > ribbon.firm);
        CHECK(is_sound(after.items, {.canvas = {after.end, 720}, .placements = after.placements}, "ribbon"));
        for (std::size_t i = 0; i < ribbon.items.size(); ++i)
            if (seat_of(ribbon.items[i], ribbon.placements[i]).centre.x < ribbon.firm)
                CHECK(after.placements[i].offset.x == doctest::Approx(ribbon.placements[i].offset.x));
        ribbon = after;
    }
    CHECK(ribbon.end >= 6 * 1280);
}

TEST_CASE("nothing new is laid out in what is seen") {
    Random random(4);
    Ribbon ribbon{.screen = {1280, 720}};
    for (int k = 0; k < 3; ++k) {
        const RibbonExtension next =
            extension(ribbon, random_items(wanted_newcomers(ribbon, 4), random), rules);
        const double before = ribbon.firm;
        ribbon = extended(ribbon, next, plan(next.request));
        for (std::size_t i = ribbon.items.size() - next.newcomers.size(); i < ribbon.items.size(); ++i)
            CHECK(bounding_box(placed_region(ribbon.items[i], ribbon.placements[i])).min.x >= before - 640);
    }
}

TEST_CASE("a ribbon of a finite width holds all items") {
    Random random(5);
    const std::vector<LayoutItem> items = random_items(17, random);
    for (const double width : {1280.0, 3000.0, 6000.0}) {
        const Layout layout = ribbon_layout(items, {1280, 720}, width, rules);
        CHECK(layout.canvas == Vec2{width, 720});
        CHECK(is_sound(items, layout, "finite_strip"));
        CHECK(layout.energy < 0.75);
    }
}
