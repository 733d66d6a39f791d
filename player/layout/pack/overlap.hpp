#pragma once

#include "base/geometry/polygon.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::player {

/// Steps of the integer grid per px. On this grid every side test is exact in 64 bits.
inline constexpr double grid_per_px = 256;

/// A point of the grid; |x|, |y| <= 2^22 (16384 px).
struct GridPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;

    bool operator==(const GridPoint&) const = default;
};

using GridPolygon = std::vector<GridPoint>;

/// The convex polygon with its corners rounded to the grid: still convex and counter-clockwise, without
/// collinear corners. Empty: no area is left.
GridPolygon snapped(std::span<const Vec2> convex);

/// The same polygon in px, exact.
Polygon to_px(const GridPolygon& polygon);

/// Areas of convex polygons that may overlap, touch or coincide, updated when single polygons move.
///
/// The area of the union is half the sum of x dy - y dx over the parts of all edges that no other polygon
/// covers. If two edges with the same direction lie on each other, the edge of the first polygon counts. A
/// move of a polygon changes only the covers between it and the others. Each polygon's share depends only on
/// the places, never on earlier moves, so the sums equal those of a new object to the last bit. In debug
/// builds every move is checked against a new object, and against union_area_by_pieces().
class UnionArea {
  public:
    /// @param polygons  convex, counter-clockwise, from snapped(); empty ones have no area
    explicit UnionArea(std::vector<GridPolygon> polygons);

    void move(std::size_t index, GridPoint by);

    std::size_t size() const { return items_.size(); }

    const GridPolygon& polygon(std::size_t index) const { return items_[index].polygon; }

    /// The area of the union, px^2, with a relative error below 1e-14.
    double area() const;

    /// The sum of the polygons' own areas, px^2, exact.
    double sum() const { return sum_; }

    /// sum() - area(): exactly 0 if no two polygons share inner points.
    /// Source: Dynamic Media Assemblage 3.4.2, eq. 3.6.
    double overlap() const { return sum_ - area(); }

    /// The smallest box around all polygons, px.
    Box bounds() const;

  private:
    struct Extent {
        std::int32_t left = 0, top = 0, right = 0, bottom = 0;
    };

    /// The part of an edge inside another polygon, in [0, 1] of its length.
    struct Cover {
        std::uint32_t edge = 0;
        std::uint32_t by = 0;
        double begin = 0;
        double end = 1;
    };

    struct Item {
        GridPolygon polygon;
        Extent extent;
        std::int64_t twice_area = 0;
        std::vector<Cover> covers;
        double exposed = 0;  // twice the polygon's share of the union's area, grid units^2
    };

    static Extent extent_of(const GridPolygon& polygon);
    static bool is_near(const Extent& a, const Extent& b);
    static Cover cover(const Item& item, std::size_t edge, const GridPolygon& other, bool yields);
    static double exposed(Item& item);
    bool separates(std::size_t one, std::size_t other);
    bool are_apart(std::size_t one, std::size_t other);
    void add_covers(std::size_t item, std::size_t by);
    bool agrees_with_fresh() const;

    std::vector<Item> items_;
    std::vector<std::uint16_t> separators_;  // at [a * size + b]: the last edge of a that had b outside
    double sum_ = 0;
};

}  // namespace vitrine::player
