#include "player/layout/pack/overlap.hpp"

#include "base/geometry/convex_hull.hpp"
#include "player/layout/pack/overlap_pieces.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vitrine::player {

namespace {

#ifdef VITRINE_CHECKS_MOVES
constexpr bool checks_moves = true;
#else
constexpr bool checks_moves = false;
#endif

std::int64_t cross_of(GridPoint a, GridPoint b) {
    return std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
}

GridPoint difference(GridPoint a, GridPoint b) {
    return {a.x - b.x, a.y - b.y};
}

GridPoint next_corner(const GridPolygon& polygon, std::size_t corner) {
    return polygon[corner + 1 == polygon.size() ? 0 : corner + 1];
}

std::int64_t twice_area_of(const GridPolygon& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += cross_of(polygon[i], next_corner(polygon, i));
    return sum;
}

/// True if no corner of `other` lies on the inner side of an edge.
bool is_outside(const GridPolygon& polygon, std::size_t edge, const GridPolygon& other) {
    const GridPoint from = polygon[edge];
    const GridPoint along = difference(next_corner(polygon, edge), from);
    return std::all_of(other.begin(), other.end(),
                       [&](GridPoint p) { return cross_of(along, difference(p, from)) <= 0; });
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

Polygon to_px(const GridPolygon& polygon) {
    Polygon points;
    for (const GridPoint p : polygon)
        points.push_back({p.x / grid_per_px, p.y / grid_per_px});
    return points;
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
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

UnionArea::UnionArea(std::vector<GridPolygon> polygons) : separators_(polygons.size() * polygons.size(), 0) {
    std::int64_t twice = 0;
    for (GridPolygon& polygon : polygons) {
        Item item{.extent = extent_of(polygon), .twice_area = twice_area_of(polygon)};
        item.polygon = std::move(polygon);
        twice += item.twice_area;
        items_.push_back(std::move(item));
    }
    sum_ = static_cast<double>(twice) / (2 * grid_per_px * grid_per_px);
    for (std::size_t i = 0; i < items_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (are_apart(i, j)) continue;
            add_covers(i, j);
            add_covers(j, i);
        }
    for (Item& item : items_)
        item.exposed = exposed(item);
}

/// True if an edge of one polygon has the whole other polygon outside. Remembers the edge.
bool UnionArea::separates(std::size_t one, std::size_t other) {
    const GridPolygon& polygon = items_[one].polygon;
    const GridPolygon& beyond = items_[other].polygon;
    for (std::size_t edge = 0; edge < polygon.size(); ++edge)
        if (is_outside(polygon, edge, beyond)) {
            separators_[one * items_.size() + other] = static_cast<std::uint16_t>(edge);
            return true;
        }
    return false;
}

/// True if two polygons share no inner points.
bool UnionArea::are_apart(std::size_t one, std::size_t other) {
    const Item& a = items_[one];
    const Item& b = items_[other];
    if (!is_near(a.extent, b.extent) || a.polygon.empty() || b.polygon.empty()) return true;
    return is_outside(a.polygon, separators_[one * items_.size() + other], b.polygon) ||
           is_outside(b.polygon, separators_[other * items_.size() + one], a.polygon) ||
           separates(one, other) || separates(other, one);
}

/// The part of an edge inside another polygon. begin >= end: there is none.
/// @param yields  true: an edge that lies on an edge of `other` with the same direction counts as inside
UnionArea::Cover UnionArea::cover(const Item& item, std::size_t edge, const GridPolygon& other, bool yields) {
    constexpr Cover none{.begin = 1, .end = 0};
    const GridPoint a = item.polygon[edge];
    const GridPoint b = next_corner(item.polygon, edge);
    Cover inside{.edge = static_cast<std::uint32_t>(edge)};
    for (std::size_t k = 0; k < other.size(); ++k) {
        const GridPoint from = other[k];
        const GridPoint along = difference(next_corner(other, k), from);
        const std::int64_t at_a = cross_of(along, difference(a, from));
        const std::int64_t at_b = cross_of(along, difference(b, from));
        if (at_a > 0 && at_b > 0) continue;
        if (at_a == 0 && at_b == 0) {
            const GridPoint way = difference(b, a);
            const bool same = std::int64_t{along.x} * way.x + std::int64_t{along.y} * way.y > 0;
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

void UnionArea::add_covers(std::size_t item, std::size_t by) {
    Item& to = items_[item];
    for (std::size_t edge = 0; edge < to.polygon.size(); ++edge) {
        Cover found = cover(to, edge, items_[by].polygon, by < item);
        if (found.begin >= found.end) continue;
        found.by = static_cast<std::uint32_t>(by);
        to.covers.push_back(found);
    }
}

/// The sum over the parts of edges that no polygon covers. Sorts the covers, so that their order does not
/// matter.
double UnionArea::exposed(Item& item) {
    std::sort(item.covers.begin(), item.covers.end(), [](const Cover& a, const Cover& b) {
        if (a.edge != b.edge) return a.edge < b.edge;
        return a.begin < b.begin || (a.begin == b.begin && a.end < b.end);
    });
    std::int64_t whole = item.twice_area;  // sum over the uncovered edges: exact
    double partly = 0;
    for (std::size_t k = 0; k < item.covers.size();) {
        const std::size_t edge = item.covers[k].edge;
        double free = 0;
        double reached = 0;
        for (; k < item.covers.size() && item.covers[k].edge == edge; ++k) {
            free += std::max(0.0, item.covers[k].begin - reached);
            reached = std::max(reached, item.covers[k].end);
        }
        const std::int64_t twice = cross_of(item.polygon[edge], next_corner(item.polygon, edge));
        whole -= twice;
        partly += static_cast<double>(twice) * (free + (1 - reached));
    }
    return static_cast<double>(whole) + partly;
}

void UnionArea::move(std::size_t index, GridPoint by) {
    Item& item = items_[index];
    for (GridPoint& p : item.polygon)
        p = {p.x + by.x, p.y + by.y};
    item.extent = {item.extent.left + by.x, item.extent.top + by.y, item.extent.right + by.x,
                   item.extent.bottom + by.y};
    item.covers.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (i == index) continue;
        const std::size_t removed =
            std::erase_if(items_[i].covers, [&](const Cover& cover) { return cover.by == index; });
        const bool apart = are_apart(index, i);
        if (!apart) {
            add_covers(index, i);
            add_covers(i, index);
        }
        if (!apart || removed > 0) items_[i].exposed = exposed(items_[i]);
    }
    item.exposed = exposed(item);
    if constexpr (checks_moves) assert(agrees_with_fresh());
}

double UnionArea::area() const {
    double twice = 0;
    for (const Item& item : items_)
        twice += item.exposed;
    return twice / (2 * grid_per_px * grid_per_px);
}

bool UnionArea::agrees_with_fresh() const {
    constexpr double tolerance = 1e-9;  // share of the sum of areas; the other computation is not exact
    std::vector<GridPolygon> polygons;
    std::vector<Polygon> in_px;
    for (const Item& item : items_) {
        polygons.push_back(item.polygon);
        in_px.push_back(to_px(item.polygon));
    }
    const double other = union_area_by_pieces(in_px);
    const UnionArea fresh(std::move(polygons));
    return fresh.area() == area() && fresh.sum() == sum() && std::abs(other - area()) <= tolerance * sum();
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

}  // namespace vitrine::player
