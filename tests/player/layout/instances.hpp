#pragma once

#include "base/geometry/convex_hull.hpp"
#include "player/layout/pack/search_budget.hpp"
#include "player/layout/plan/plan.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace vitrine::player {

/// An item like those of real media: a convex region somewhere in a frame of a usual size.
inline LayoutItem random_item(Random& random) {
    constexpr Vec2 sizes[] = {{1920, 1080}, {1280, 720}, {3000, 2000},
                              {2000, 3000}, {640, 360},  {1080, 1920}};
    const Vec2 size = sizes[uniform_index(random, std::size(sizes))];
    const double x = uniform(random);
    const Vec2 middle{size.x * (0.3 + 0.4 * x), size.y * (0.3 + 0.4 * uniform(random))};
    Polygon points;
    for (int i = 0; i < 12; ++i) {
        const double angle = uniform(random) * 2 * std::numbers::pi;
        const double reach = 0.5 + 0.5 * uniform(random);
        points.push_back(middle +
                         Vec2{std::cos(angle) * size.x * 0.35, std::sin(angle) * size.y * 0.4} * reach);
    }
    const Box core{{0, 0}, size};
    return {.region = clipped(convex_hull(points), core), .core = core};
}

inline PlanRequest random_request(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    PlanRequest request{.canvas = {1920, 1080}, .seed = seed, .budget = 30'000, .max_scale = 4};
    for (std::size_t i = 0; i < count; ++i)
        request.items.push_back({.item = random_item(random)});
    return request;
}

/// The same on another canvas, planned shortly.
inline PlanRequest random_request_on(const Canvas& canvas, std::size_t count, std::uint64_t seed) {
    PlanRequest request = random_request(count, seed);
    request.canvas = canvas;
    request.budget = 20'000;
    return request;
}

/// Two outputs of one size beside each other.
inline Canvas two_outputs(Vec2 output, double gap) {
    return canvas_of({2 * output.x + gap, output.y},
                     {{{0, 0}, output}, {{output.x + gap, 0}, {2 * output.x + gap, output.y}}});
}

inline std::vector<LayoutItem> items_of(const PlanRequest& request) {
    std::vector<LayoutItem> items;
    for (const PlanItem& item : request.items)
        items.push_back(item.item);
    return items;
}

}  // namespace vitrine::player
