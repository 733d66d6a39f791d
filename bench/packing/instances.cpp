#include "base/geometry/convex_hull.hpp"
#include "base/state/catalogue.hpp"
#include "bench/packing/bench.hpp"
#include "player/layout/layout.hpp"

#include <cmath>
#include <ctime>

namespace vitrine::player {

namespace {

LayoutItem random_hull(Random& random) {
    Polygon points;
    const std::size_t count = 8 + uniform_index(random, 24);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = uniform(random);
        points.push_back({x * 1000, uniform(random) * 1000});
    }
    LayoutItem item{.region = convex_hull(points)};
    const double side = std::sqrt(area(item.region) / std::pow(4.0, uniform(random))) * 100;
    item.core = {{0, 0}, {side, side}};  // only its area counts here
    return item;
}

}  // namespace

double cpu_ms() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Items regions_of(const std::string& directory) {
    Items items;
    for (const MediaRecord& record : Catalogue(directory).load())
        if (record.state == MediaState::ready)
            for (const Shot& shot : record.shots)
                items.push_back(layout_item(record, shot));
    return items;
}

Items random_hulls(std::size_t count, Random& random) {
    Items items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(random_hull(random));
    return items;
}

Draw drawn_from(const Items& items) {
    return [&items](std::size_t count, Random& random) {
        Items drawn;
        for (std::size_t i = 0; i < count; ++i)
            drawn.push_back(items[uniform_index(random, items.size())]);
        return drawn;
    };
}

ScaledItems scaled(const Items& items) {
    ScaledItems result;
    for (const LayoutItem& item : items)
        result.shapes.push_back(shape_of(item.region));
    result.scales = natural_scales(items, result.shapes);
    double sum = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        sum += result.shapes[i].area * result.scales[i] * result.scales[i];
    result.area = 0.5 * bench_canvas.x * bench_canvas.y;
    for (double& scale : result.scales)
        scale *= std::sqrt(result.area / sum);
    return result;
}

PlanRequest request_for(const Items& items, std::uint64_t seed) {
    PlanRequest request{.canvas = bench_canvas, .seed = seed, .max_scale = 100, .fills = false};
    for (const LayoutItem& item : items)
        request.items.push_back({.item = item});
    return request;
}

}  // namespace vitrine::player
