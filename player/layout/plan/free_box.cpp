#include "player/layout/plan/free_box.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace vitrine::player {

namespace {

struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
};

Extent extent_along(const Polygon& polygon, Vec2 axis) {
    Extent extent;
    for (const Vec2& p : polygon) {
        extent.min = std::min(extent.min, dot(p, axis));
        extent.max = std::max(extent.max, dot(p, axis));
    }
    return extent;
}

/// True if a line across this axis lies between both, with a clearance. @param axis  of length 1
bool are_apart_along(const Polygon& a, const Polygon& b, Vec2 axis, double clearance) {
    const Extent one = extent_along(a, axis);
    const Extent other = extent_along(b, axis);
    return other.min - one.max >= clearance || one.min - other.max >= clearance;
}

}  // namespace

bool is_clear_of(const Box& box, const Polygon& polygon, double clearance) {
    const Polygon corners = to_polygon(box);
    if (are_apart_along(corners, polygon, {1, 0}, clearance)) return true;
    if (are_apart_along(corners, polygon, {0, 1}, clearance)) return true;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 along = polygon[(k + 1) % polygon.size()] - polygon[k];
        const double size = length(along);
        if (size > 0 && are_apart_along(corners, polygon, Vec2{along.y, -along.x} * (1 / size), clearance))
            return true;
    }
    return false;
}

bool grow_box(Box& box, const Box& field, std::span<const Polygon> others, double clearance, double step) {
    constexpr int halvings = 6;
    bool has_grown = false;
    const std::array<double*, 4> sides{&box.min.x, &box.min.y, &box.max.x, &box.max.y};
    const std::array<double, 4> limits{field.min.x, field.min.y, field.max.x, field.max.y};
    for (std::size_t side = 0; side < sides.size(); ++side) {
        double by = std::min(step, std::abs(limits[side] - *sides[side]));
        const double before = *sides[side];
        const double direction = side < 2 ? -1 : 1;
        for (int k = 0; k < halvings && by > 0; ++k, by /= 2) {
            *sides[side] = before + direction * by;
            const bool is_free = std::ranges::all_of(
                others, [&](const Polygon& other) { return is_clear_of(box, other, clearance); });
            if (is_free) break;
            *sides[side] = before;
        }
        has_grown = has_grown || std::abs(*sides[side] - before) >= 1;
    }
    return has_grown;
}

}  // namespace vitrine::player
