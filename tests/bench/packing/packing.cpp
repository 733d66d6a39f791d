// How densely and how fast I-Regions are packed: the paper's way and ours, on the same instances.
//   packing [INSTANCES]

#include "base/geometry/convex_hull.hpp"
#include "player/layout/effort.hpp"
#include "player/layout/plan.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

using namespace vitrine;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The hull of 8 to 31 random points, areas within a factor of 4, scaled so that packing keeps its size.
LayoutItem random_item(Random& random) {
    Polygon points;
    const std::size_t count = 8 + uniform_index(random, 24);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = uniform(random);
        const double y = uniform(random);
        points.push_back({x * 1000, y * 1000});
    }
    LayoutItem item{.region = convex_hull(points)};
    const double wanted = std::pow(4.0, uniform(random));
    item.core = {{0, 0}, {std::sqrt(area(item.region) / wanted * 1e4), 0}};
    item.core.max.y = item.core.max.x;
    return item;
}

std::vector<PlanItem> random_items(std::size_t count, Random& random) {
    std::vector<PlanItem> items(count);
    for (PlanItem& item : items)
        item.item = random_item(random);
    return items;
}

}  // namespace

int main(int argc, char** argv) {
    const int instances = argc > 1 ? std::atoi(argv[1]) : 10;
    for (const std::size_t n : {4, 6, 8, 12, 24}) {
        double greedy = 0;
        double t_greedy = 0;
        double short_ = 0;
        double long_ = 0;
        double moves = 0;
        for (int k = 0; k < instances; ++k) {
            Random random(static_cast<std::uint64_t>(k) + 1);
            PlanRequest request{.items = random_items(n, random), .canvas = {1920, 1080}, .most_scale = 100};
            request.budget = 0;
            auto start = Clock::now();
            greedy += 1 - plan(request).energy;
            t_greedy += seconds_since(start);
            for (const double limit : {0.1, 1.0}) {
                request.budget = static_cast<std::int64_t>(1e6 * limit);
                start = Clock::now();
                const Layout layout = plan(request);
                const double t = seconds_since(start);
                if (limit == 1.0) moves += 1e6 / t;
                (limit == 1.0 ? long_ : short_) += 1 - layout.energy;
            }
        }
        fmt::print("{:3} greedy {:.3f} {:.2f} ms   100k {:.3f}  1M {:.3f}  {:.2f} Mmoves/s\n", n,
                   greedy / instances, 1e3 * t_greedy / instances, short_ / instances, long_ / instances,
                   moves / instances / 1e6);
    }
}
