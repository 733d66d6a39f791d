#include "base/geometry/convex_hull.hpp"

#include <algorithm>

namespace vitrine {

namespace {

/// Walks along sorted points and keeps the points at which the walk turns counter-clockwise.
template <typename Iterator> void append_chain(Polygon& hull, Iterator first, Iterator last) {
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
        while (hull.size() >= start + 2 &&
               cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(*first);
    }
    hull.pop_back();  // the other chain starts with it
}

}  // namespace

Polygon convex_hull(std::span<const Vec2> points) {
    Polygon sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    Polygon hull;
    append_chain(hull, sorted.begin(), sorted.end());
    append_chain(hull, sorted.rbegin(), sorted.rend());
    return hull;
}

}  // namespace vitrine
