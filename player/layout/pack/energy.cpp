#include "player/layout/pack/energy.hpp"

#include "player/layout/pack/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vitrine::player {

namespace {

constexpr double occlusion_weight = 1e5;  // k, eq. 3.4
constexpr double ratio_epsilon = 1e-6;    // eq. 3.7

/// ln(e^a + e^b)
double log_of_sum(double a, double b) {
    const double larger = std::max(a, b);
    if (std::isinf(larger)) return larger;
    return larger + std::log1p(std::exp(std::min(a, b) - larger));
}

double log_or_nothing(double value) {
    return value > 0 ? std::log(value) : -std::numeric_limits<double>::infinity();
}

}  // namespace

Measure measured(std::span<const LayoutItem> items, std::span<const Placement> placements) {
    std::vector<GridPolygon> regions;
    for (std::size_t i = 0; i < items.size(); ++i)
        regions.push_back(snapped(placed_region(items[i], placements[i])));
    const UnionArea areas(std::move(regions));
    return {areas.area(), areas.overlap(), areas.bounds()};
}

double paper_energy(const Measure& measure, double ratio) {
    const double deviation = measure.bounds.width() / measure.bounds.height() - ratio;
    const double alpha = 1 / (deviation * deviation + ratio_epsilon);
    const double empty = 1 - measure.united / measure.bounds.area();
    return log_of_sum(alpha * log_or_nothing(empty), log_or_nothing(occlusion_weight * measure.hidden));
}

double screen_area(const Box& bounds, double ratio) {
    const double width = std::max(bounds.width(), ratio * bounds.height());
    return width * width / ratio;
}

}  // namespace vitrine::player
