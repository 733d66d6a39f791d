#include "player/layout/plan/plan_by_outputs.hpp"

#include "player/layout/plan/bands.hpp"
#include "player/layout/plan/flat_plan.hpp"
#include "player/layout/plan/plan.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/real_items.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("outputs planned by themselves share the items out by area") {
    const PlanRequest request = random_request_on(two_outputs({640, 360}, 40), 6, 4);
    const Layout layout = plan_by_outputs(request, {}, plan_flat);
    CHECK(is_clear_of_bands(request, layout.placements));
    CHECK(is_sound(items_of(request), layout, "bands_by_outputs"));
    const auto on_first = std::ranges::count_if(request.items, [&](const PlanItem& item) {
        const auto i = static_cast<std::size_t>(&item - request.items.data());
        return seat_of(item.item, layout.placements[i]).centre.x < 640;
    });
    CHECK(on_first >= 2);
    CHECK(on_first <= 4);
}

TEST_CASE("as many copies of a picture as outputs: one on each") {
    const Canvas grid = canvas_of(
        {1320, 760},
        {{{0, 0}, {640, 360}}, {{680, 0}, {1320, 360}}, {{0, 400}, {640, 760}}, {{680, 400}, {1320, 760}}});
    const std::vector<LayoutItem> items = real_items();
    for (const Canvas& canvas : {two_outputs({640, 360}, 40), grid})
        for (std::size_t picture = 0; picture < items.size(); ++picture) {
            PlanRequest request{.canvas = canvas, .seed = picture + 1, .max_scale = 4};
            for (std::size_t k = 0; k < canvas.outputs.size(); ++k)
                request.items.push_back({.item = items[picture]});
            const Layout layout = plan(request);
            std::set<std::size_t> used;
            for (const Placement& at : layout.placements) {
                const Box shown = output_of(canvas, bounding_box(placed_region(items[picture], at)));
                used.insert(static_cast<std::size_t>(std::ranges::find(canvas.outputs, shown) -
                                                     canvas.outputs.begin()));
            }
            CAPTURE(picture);
            CHECK(used.size() == canvas.outputs.size());
        }
}

TEST_CASE("an output is planned once for the same items, however they came to it") {
    const PlanRequest request = random_request_on(two_outputs({640, 360}, 40), 5, 2);
    std::multiset<std::vector<double>> planned;
    const auto plan_one = [&](const PlanRequest& part, const PlanWatch& watch) {
        std::vector<double> key{static_cast<double>(part.budget)};
        for (const PlanItem& item : part.items)
            key.push_back(item.item.region.front().x);
        planned.insert(key);
        return plan_flat(part, watch);
    };
    const Layout layout = best_plan_by_outputs(request, {}, plan_one);
    CHECK(is_clear_of_bands(request, layout.placements));
    CHECK(planned.size() >= 10);
    for (const std::vector<double>& key : planned)
        CHECK(planned.count(key) == 1);
}

TEST_CASE("real regions cover nearly as much of two outputs as of a canvas without a bezel") {
    std::vector<LayoutItem> all = real_items();
    for (const LayoutItem& item : wide_items())
        all.push_back(item);
    double with = 0;
    double without = 0;
    for (std::size_t wall = 0; wall < 2; ++wall) {
        PlanRequest request{.canvas = two_outputs({1920, 1080}, 40), .seed = wall + 1, .max_scale = 4};
        for (std::size_t k = 0; k < 6; ++k)
            request.items.push_back({.item = all[(3 * wall + 2 * k) % all.size()]});
        with += covered_px(request, plan(request)) / (2 * 1920 * 1080);
        const double px = request.canvas.x * request.canvas.y;
        request.canvas = Canvas(Vec2(request.canvas));
        without += covered_px(request, plan(request)) / px;
    }
    CAPTURE(with / 2);
    CAPTURE(without / 2);
    CHECK(with >= 0.97 * without);
}

TEST_CASE("a turn on one output leaves the others as they are, and no hole") {
    const std::vector<LayoutItem> all = real_items();
    PlanRequest request{
        .canvas = two_outputs({1920, 1080}, 40), .seed = 1, .budget = 100'000, .max_scale = 4};
    for (std::size_t k = 0; k < 12; ++k)
        request.items.push_back({.item = all[k % all.size()]});
    Layout layout = plan(request);
    for (std::size_t turn = 0; turn < 4; ++turn) {
        const double middle = request.canvas.x / 2;
        const std::size_t leaving = 2 * turn % 12;
        const Seat seat = seat_of(request.items[leaving].item, layout.placements[leaving]);
        for (std::size_t i = 0; i < 12; ++i)
            request.items[i].previous = layout.placements[i];
        request.items[leaving] = {.item = all[(leaving + 3) % all.size()], .seat = seat};
        const Layout next = plan(request);
        CAPTURE(turn);
        CHECK(is_sound(items_of(request), next, "turn_of_an_output"));
        CHECK(unseen_share(request, next) <= 0.01);
        for (std::size_t i = 0; i < 12; ++i) {
            const bool is_there = seat_of(request.items[i].item, layout.placements[i]).centre.x < middle;
            if (i != leaving && is_there != (seat.centre.x < middle))
                CHECK(next.placements[i] == layout.placements[i]);
        }
        layout = next;
    }
}
