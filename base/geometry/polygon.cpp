#include "base/geometry/polygon.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine {

double signed_area(std::span<const Vec2> polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return twice / 2;
}

double area(std::span<const Vec2> polygon) {
    return std::abs(signed_area(polygon));
}

Vec2 centroid(std::span<const Vec2> polygon) {
    assert(!polygon.empty());
    const Vec2 origin = polygon[0];
    Vec2 moment;
    Vec2 mean;
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i] - origin;
        const Vec2 b = polygon[(i + 1) % polygon.size()] - origin;
        const double c = cross(a, b);
        twice += c;
        moment = moment + (a + b) * c;
        mean = mean + a;
    }
    if (twice == 0) return origin + mean * (1.0 / static_cast<double>(polygon.size()));
    return origin + moment * (1 / (3 * twice));
}

Box bounding_box(std::span<const Vec2> polygon) {
    assert(!polygon.empty());
    Box box{polygon[0], polygon[0]};
    for (const Vec2& p : polygon) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

Polygon to_polygon(const Box& box) {
    return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

Polygon transformed(std::span<const Vec2> polygon, double scale, Vec2 offset) {
    Polygon result;
    result.reserve(polygon.size());
    for (const Vec2& p : polygon)
        result.push_back(p * scale + offset);
    return result;
}

bool is_inside_convex(std::span<const Vec2> polygon, Vec2 point, double tolerance) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        if (cross(edge, point - polygon[i]) < -tolerance * length(edge)) return false;
    }
    return !polygon.empty();
}

namespace {

/// Keeps the part on the side normal . p <= limit (Sutherland-Hodgman, one plane).
Polygon clipped_by_plane(const Polygon& polygon, Vec2 normal, double limit) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i];
        const Vec2 b = polygon[(i + 1) % polygon.size()];
        const double da = dot(normal, a) - limit;
        const double db = dot(normal, b) - limit;
        if (da <= 0) result.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) result.push_back(a + (b - a) * (da / (da - db)));
    }
    return result;
}

}  // namespace

Polygon clipped(std::span<const Vec2> convex, const Box& box) {
    Polygon result(convex.begin(), convex.end());
    result = clipped_by_plane(result, {1, 0}, box.max.x);
    result = clipped_by_plane(result, {-1, 0}, -box.min.x);
    result = clipped_by_plane(result, {0, 1}, box.max.y);
    result = clipped_by_plane(result, {0, -1}, -box.min.y);
    if (result.size() < 3 || area(result) == 0) return {};
    return result;
}

}  // namespace vitrine
