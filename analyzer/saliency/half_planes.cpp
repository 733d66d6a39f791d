#include "analyzer/saliency/half_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr double same_point = 1e-6;  // px
constexpr double parallel = 1e-9;    // sine of the angle between two edges

Polygon cut_by(const Polygon& polygon, const HalfPlane& plane) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 a = polygon[i];
        const Vec2 b = polygon[(i + 1) % polygon.size()];
        const double outside_a = dot(a, plane.normal) - plane.offset;
        const double outside_b = dot(b, plane.normal) - plane.offset;
        if (outside_a <= 0) result.push_back(a);
        if ((outside_a < 0 && outside_b > 0) || (outside_a > 0 && outside_b < 0)) {
            result.push_back(a + (b - a) * (outside_a / (outside_a - outside_b)));
        }
    }
    return result;
}

/// The polygon without corners that repeat or lie on the line of their neighbours.
Polygon tidied(const Polygon& polygon) {
    Polygon distinct;
    for (const Vec2 p : polygon) {
        if (distinct.empty() || length(p - distinct.back()) > same_point) distinct.push_back(p);
    }
    while (distinct.size() > 1 && length(distinct.front() - distinct.back()) <= same_point)
        distinct.pop_back();
    Polygon result;
    for (std::size_t i = 0; i < distinct.size(); ++i) {
        const Vec2 in = distinct[i] - distinct[(i + distinct.size() - 1) % distinct.size()];
        const Vec2 out = distinct[(i + 1) % distinct.size()] - distinct[i];
        if (cross(in, out) > parallel * length(in) * length(out)) result.push_back(distinct[i]);
    }
    return result.size() >= 3 ? result : Polygon{};
}

/// The point where the lines through (a, b) and (c, d) meet beyond b and before c.
std::optional<Vec2> meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 u = b - a;
    const Vec2 v = d - c;
    const double sine = cross(u, v);
    if (sine <= parallel * length(u) * length(v)) return std::nullopt;
    return a + u * (cross(c - a, v) / sine);
}

struct Removal {
    std::size_t edge = 0;
    Vec2 corner;
    double added = std::numeric_limits<double>::infinity();
};

Removal cheapest_removal(const Polygon& p) {
    Removal best;
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 b = p[i];
        const Vec2 c = p[(i + 1) % n];
        const std::optional<Vec2> corner = meeting(p[(i + n - 1) % n], b, c, p[(i + 2) % n]);
        if (!corner) continue;
        const double added = std::abs(cross(c - b, *corner - b)) / 2;
        if (added < best.added) best = {i, *corner, added};
    }
    return best;
}

}  // namespace

Polygon cut_by(Polygon convex, std::span<const HalfPlane> planes) {
    for (const HalfPlane& plane : planes)
        convex = cut_by(convex, plane);
    return tidied(convex);
}

Polygon widened(const Polygon& convex, double distance) {
    Polygon result;
    const std::size_t n = convex.size();
    const auto outward = [&](std::size_t i) {
        const Vec2 edge = convex[(i + 1) % n] - convex[i];
        return Vec2{edge.y, -edge.x} * (1 / length(edge));
    };
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = outward((i + n - 1) % n);
        const Vec2 after = outward(i);
        // The corner moves along the bisector so that both edges move by the distance.
        result.push_back(convex[i] + (before + after) * (distance / (1 + dot(before, after))));
    }
    return result;
}

Polygon simplified_outward(Polygon convex, std::size_t corners) {
    while (convex.size() > std::max<std::size_t>(corners, 4)) {
        const Removal removal = cheapest_removal(convex);
        if (!std::isfinite(removal.added)) break;
        convex[removal.edge] = removal.corner;
        convex.erase(convex.begin() + static_cast<std::ptrdiff_t>((removal.edge + 1) % convex.size()));
    }
    return convex;
}

Polygon simplified_within(const Polygon& convex, std::size_t corners, const Box& box) {
    Polygon result = convex;
    for (std::size_t aim = corners; aim >= 4; --aim) {
        result = tidied(clipped(simplified_outward(convex, aim), box));
        if (result.size() <= corners) break;
    }
    return result;
}

}  // namespace vitrine::analyzer
