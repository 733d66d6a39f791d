#include "player/layout/pack/few_items.hpp"

#include "player/layout/pack/coarse_filling.hpp"
#include "player/layout/plan/plan_output.hpp"
#include "tests/player/layout/fair_shares.hpp"
#include "tests/player/layout/instances.hpp"
#include "tests/player/layout/real_items.hpp"
#include "tests/player/layout/soundness.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// Pictures may be enlarged much, as if all had the pixels that cameras give them.
PlanRequest request_of(const std::vector<LayoutItem>& items, Vec2 canvas) {
    PlanRequest request{.canvas = canvas, .max_scale = 6};
    for (const LayoutItem& item : items)
        request.items.push_back({.item = item});
    return request;
}

/// The share of the canvas that no picture reaches.
double empty_of(const std::vector<LayoutItem>& items, const Layout& layout) {
    std::vector<NamedItem> named;
    for (const LayoutItem& item : items)
        named.push_back({"item", named.size(), item});
    return 1 - plan_result(named, layout).canvas_filled;
}

/// A problem of square regions in the middle of frames.
struct Framed {
    PackingProblem problem;
    std::vector<Box> frames;

    void add(double region, Vec2 frame) {
        problem.shapes.push_back(shape_of(to_polygon({{0, 0}, {region, region}})));
        problem.scales.push_back(1);
        problem.limits.push_back(2);
        problem.pinned.push_back(false);
        problem.pinned_places.emplace_back();
        frames.push_back({frame * -0.5, frame * 0.5});
    }
};

}  // namespace

TEST_CASE("three real pictures fill a wide screen, and none is tiny") {
    const std::vector<LayoutItem> all = real_items();
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::vector<LayoutItem> items{all[k], all[(k + 1) % all.size()], all[(k + 3) % all.size()]};
        const PlanRequest request = request_of(items, {1920, 1080});
        const Layout layout = plan(request);
        CAPTURE(k);
        CHECK(is_sound(items, layout, "few"));
        CHECK(std::ranges::min(fair_shares(items, layout.placements, request.max_scale)) >= 0.4);
        const double empty = empty_of(items, layout);
        CHECK(empty <= 0.06);
        sum += empty;
        ++count;
    }
    CHECK(sum / count <= 0.03);
}

TEST_CASE("three to five real pictures fill screens of other shapes") {
    const std::vector<LayoutItem> all = real_items();
    for (const Vec2 canvas : {Vec2{1080, 1920}, Vec2{1440, 1080}})
        for (std::size_t count = 3; count <= 5; ++count) {
            const auto first = static_cast<std::ptrdiff_t>(7 - count);
            const std::vector<LayoutItem> items(all.begin() + first, all.end());
            const Layout layout = plan(request_of(items, canvas));
            CAPTURE(canvas.x);
            CAPTURE(count);
            CHECK(is_sound(items, layout, "few"));
            CHECK(empty_of(items, layout) <= 0.03);
        }
}

TEST_CASE("pictures that must change their sizes together fill a screen") {
    const std::vector<LayoutItem> photos = wide_items();
    const auto check = [](const std::vector<LayoutItem>& items, Vec2 canvas) {
        PlanRequest request = request_of(items, canvas);
        request.max_scale = 1.5;
        const Layout layout = plan(request);
        CHECK(is_sound(items, layout, "together"));
        CHECK(empty_of(items, layout) <= 0.02);
    };
    check({photos[0], photos[1]}, {1920, 1080});
    check({photos[4], photos[0]}, {1920, 1080});
    check({photos[2], photos[1], photos[0], photos[3]}, {3840, 1080});
}

TEST_CASE("one of three real pictures is replaced, and the screen is still filled") {
    const std::vector<LayoutItem> all = real_items();
    std::vector<LayoutItem> items{all[0], all[4], all[6]};
    Layout layout = plan(request_of(items, {1920, 1080}));
    for (const std::size_t next : {5, 1}) {
        PlanRequest request = request_of(items, {1920, 1080});
        for (std::size_t i = 0; i < items.size(); ++i)
            request.items[i].previous = layout.placements[i];
        const Seat seat = seat_of(items[1], layout.placements[1]);
        items[1] = all[next];
        request.items[1] = {.item = items[1], .seat = seat};
        layout = plan(request);
        CHECK(is_sound(items, layout, "replaced"));
        CHECK(empty_of(items, layout) <= 0.08);
    }
}

TEST_CASE("coarse steps fill a hole, make nothing smaller, and are the same each time") {
    Framed made;
    made.problem.field = {{0, 0}, {200, 100}};
    made.add(40, {100, 100});
    made.add(40, {70, 100});
    const Arrangement start{{{50, 50}, {135, 50}}, 1};
    const double before = unfilled_share(made.problem, made.frames, start);
    PackingProblem problem = made.problem;
    const Arrangement end = coarsely_filled(problem, made.frames, start);
    CHECK(before > 0.1);
    CHECK(unfilled_share(problem, made.frames, end) < before / 2);
    CHECK(problem.scales[0] >= 1);
    CHECK(problem.scales[1] >= 1);
    PackingProblem again = made.problem;
    CHECK(coarsely_filled(again, made.frames, start).places == end.places);
    CHECK(again.scales == problem.scales);
}

TEST_CASE("a thin band at the edge counts as not filled") {
    Framed made;
    made.problem.field = {{0, 0}, {200, 200}};
    made.add(40, {198.6, 400});
    CHECK(unfilled_share(made.problem, made.frames, {{{99.3, 100}}, 1}) > 0.01);
    CHECK(unfilled_share(made.problem, made.frames, {{{100, 100}}, 1}) > 0.01);
}
