#include "base/geometry/overlap.hpp"

#include "base/geometry/convex_hull.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine {

namespace {

struct Interval {
    double begin = 0;
    double end = 1;
};

std::int64_t cross_of(GridPoint a, GridPoint b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

GridPoint difference(GridPoint a, GridPoint b) {
    return {a.x - b.x, a.y - b.y};
}

std::int64_t twice_area(const GridPolygon& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += cross_of(polygon[i], polygon[(i + 1) % polygon.size()]);
    return sum;
}

/// The stretch of the edge a -> b inside `other`, as parameters in [0, 1]; begin >= end: none.
/// @param yields  whether an edge on one of other's, of the same direction, counts as inside
Interval covered(GridPoint a, GridPoint b, const GridPolygon& other, bool yields) {
    constexpr Interval none{1, 0};
    Interval inside;
    for (std::size_t k = 0; k < other.size(); ++k) {
        const GridPoint from = other[k];
        const GridPoint along = difference(other[(k + 1) % other.size()], from);
        const std::int64_t at_a = cross_of(along, difference(a, from));
        const std::int64_t at_b = cross_of(along, difference(b, from));
        if (at_a > 0 && at_b > 0) continue;
        if (at_a == 0 && at_b == 0) {
            const GridPoint edge = difference(b, a);
            const bool same = std::int64_t{along.x} * edge.x + std::int64_t{along.y} * edge.y > 0;
            if (same && yields) continue;
            return none;
        }
        if (at_a <= 0 && at_b <= 0) return none;
        const double crossing = static_cast<double>(at_a) / static_cast<double>(at_a - at_b);
        if (at_a <= 0) inside.begin = std::max(inside.begin, crossing);
        if (at_b <= 0) inside.end = std::min(inside.end, crossing);
        if (inside.begin >= inside.end) return none;
    }
    return inside;
}

/// 1 minus the length of the union of intervals within [0, 1]; reorders them.
double exposed_share(std::vector<Interval>& intervals) {
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) {
        return a.begin < b.begin || (a.begin == b.begin && a.end < b.end);
    });
    double free = 0;
    double reached = 0;
    for (const Interval& interval : intervals) {
        free += std::max(0.0, interval.begin - reached);
        reached = std::max(reached, interval.end);
    }
    return free + (1 - reached);
}

}  // namespace

GridPolygon snapped(std::span<const Vec2> convex) {
    Polygon rounded;
    rounded.reserve(convex.size());
    for (const Vec2& p : convex)
        rounded.push_back({std::round(p.x * grid_per_px), std::round(p.y * grid_per_px)});
    GridPolygon result;
    for (const Vec2& p : convex_hull(rounded))
        result.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
    if (result.size() < 3) result.clear();
    return result;
}

UnionArea::Extent UnionArea::extent_of(const GridPolygon& polygon) {
    if (polygon.empty()) return {};
    Extent extent{polygon[0].x, polygon[0].y, polygon[0].x, polygon[0].y};
    for (const GridPoint& p : polygon) {
        extent.left = std::min(extent.left, p.x);
        extent.right = std::max(extent.right, p.x);
        extent.top = std::min(extent.top, p.y);
        extent.bottom = std::max(extent.bottom, p.y);
    }
    return extent;
}

bool UnionArea::is_near(const Extent& a, const Extent& b) {
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

UnionArea::UnionArea(std::vector<GridPolygon> polygons) {
    std::int64_t twice = 0;
    for (GridPolygon& polygon : polygons) {
        twice += twice_area(polygon);
        const Extent extent = extent_of(polygon);
        items_.push_back({std::move(polygon), extent});
    }
    sum_ = static_cast<double>(twice) / (2 * grid_per_px * grid_per_px);
    for (std::size_t i = 0; i < items_.size(); ++i)
        items_[i].exposed = exposed(i);
}

void UnionArea::move(std::size_t index, GridPoint by) {
    Item& item = items_[index];
    const Extent before = item.extent;
    for (GridPoint& p : item.polygon)
        p = {p.x + by.x, p.y + by.y};
    item.extent = extent_of(item.polygon);
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const Extent& extent = items_[i].extent;
        if (i == index || is_near(extent, before) || is_near(extent, item.extent))
            items_[i].exposed = exposed(i);
    }
}

double UnionArea::exposed(std::size_t index) const {
    std::vector<Interval> intervals;
    std::vector<std::size_t> near;
    const Item& item = items_[index];
    for (std::size_t j = 0; j < items_.size(); ++j)
        if (j != index && !items_[j].polygon.empty() && is_near(item.extent, items_[j].extent))
            near.push_back(j);
    double whole = 0;  // edges nobody covers: integers, exact
    double partly = 0;
    for (std::size_t e = 0; e < item.polygon.size(); ++e) {
        const GridPoint a = item.polygon[e];
        const GridPoint b = item.polygon[(e + 1) % item.polygon.size()];
        intervals.clear();
        for (const std::size_t j : near) {
            const Interval inside = covered(a, b, items_[j].polygon, j < index);
            if (inside.begin < inside.end) intervals.push_back(inside);
        }
        const auto twice = static_cast<double>(cross_of(a, b));
        if (intervals.empty())
            whole += twice;
        else
            partly += twice * exposed_share(intervals);
    }
    return whole + partly;
}

double UnionArea::area() const {
    double twice = 0;
    for (const Item& item : items_)
        twice += item.exposed;
    return twice / (2 * grid_per_px * grid_per_px);
}

Box UnionArea::bounds() const {
    Extent all;
    bool any = false;
    for (const Item& item : items_) {
        if (item.polygon.empty()) continue;
        const Extent& e = item.extent;
        if (!any) all = e;
        any = true;
        all = {std::min(all.left, e.left), std::min(all.top, e.top), std::max(all.right, e.right),
               std::max(all.bottom, e.bottom)};
    }
    return {{all.left / grid_per_px, all.top / grid_per_px},
            {all.right / grid_per_px, all.bottom / grid_per_px}};
}

}  // namespace vitrine
