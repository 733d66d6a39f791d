#include "player/layout/cells/voronoi_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vitrine::player {

namespace {

constexpr double slack = 0.5;     // px: twice the error of flattened curves
constexpr double area_slack = 1;  // px^2

double squared(double x) {
    return x * x;
}

/// The squared distance of a point from a box; 0: it is inside.
double squared_distance(const Box& box, Vec2 p) {
    return squared(std::max({box.min.x - p.x, 0.0, p.x - box.max.x})) +
           squared(std::max({box.min.y - p.y, 0.0, p.y - box.max.y}));
}

/// The same from a convex polygon.
double squared_distance(const Polygon& region, Vec2 p) {
    bool is_inside = region.size() > 2;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Vec2 a = region[k];
        const Vec2 edge = region[(k + 1) % region.size()] - a;
        const double size = dot(edge, edge);
        const double share = size > 0 ? std::clamp(dot(p - a, edge) / size, 0.0, 1.0) : 0;
        const Vec2 way = p - (a + edge * share);
        least = std::min(least, dot(way, way));
        is_inside = is_inside && cross(edge, p - a) >= 0;
    }
    return is_inside ? 0 : least;
}

}  // namespace

bool are_nearest(std::span<const Loops> cells, std::span<const Polygon> regions, const Box& canvas) {
    std::vector<Box> boxes;
    boxes.reserve(regions.size());
    for (const Polygon& region : regions)
        boxes.push_back(bounding_box(region));
    const auto is_own = [&](std::size_t own, Vec2 p) {
        const double limit = squared(std::max(0.0, std::sqrt(squared_distance(regions[own], p)) - slack));
        for (std::size_t j = 0; j < regions.size(); ++j)
            if (j != own && squared_distance(boxes[j], p) < limit && squared_distance(regions[j], p) < limit)
                return false;
        return true;
    };
    for (std::size_t i = 0; i < regions.size(); ++i) {
        if (regions[i].size() > 2 && area_of(cells[i]) < area(regions[i]) - area_slack) return false;
        for (const Loop& loop : cells[i])
            for (const CellPoint& corner : loop)
                if (const Vec2 p = from_grid(corner); squared_distance(canvas, p) <= 0 && !is_own(i, p))
                    return false;
    }
    return true;
}

}  // namespace vitrine::player
