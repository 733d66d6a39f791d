#include "player/layout/pack/overlap_pieces.hpp"

#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

/// The part on the inner (side 1) or the outer (side -1) side of the line from -> to.
Polygon cut(const Polygon& convex, Vec2 from, Vec2 to, double side) {
    Polygon result;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 a = convex[i];
        const Vec2 b = convex[(i + 1) % convex.size()];
        const double at_a = side * cross(to - from, a - from);
        const double at_b = side * cross(to - from, b - from);
        if (at_a >= 0) result.push_back(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
            result.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    if (result.size() < 3) result.clear();
    return result;
}

/// Appends the convex pieces of a polygon outside another one.
void subtract(Polygon from, const Polygon& other, std::vector<Polygon>& pieces) {
    if (intersection(bounding_box(from), bounding_box(other)).is_empty()) {
        pieces.push_back(std::move(from));
        return;
    }
    for (std::size_t k = 0; k < other.size() && !from.empty(); ++k) {
        const Vec2 a = other[k];
        const Vec2 b = other[(k + 1) % other.size()];
        Polygon outside = cut(from, a, b, -1);
        if (!outside.empty()) pieces.push_back(std::move(outside));
        from = cut(from, a, b, 1);
    }
}

}  // namespace

double union_area_by_pieces(std::span<const Polygon> polygons) {
    std::vector<Polygon> before;
    double sum = 0;
    for (const Polygon& polygon : polygons) {
        if (polygon.empty()) continue;
        std::vector<Polygon> pieces{polygon};
        for (const Polygon& other : before) {
            std::vector<Polygon> left;
            for (Polygon& piece : pieces)
                subtract(std::move(piece), other, left);
            pieces = std::move(left);
        }
        for (const Polygon& piece : pieces)
            sum += signed_area(piece);
        before.push_back(polygon);
    }
    return sum;
}

}  // namespace vitrine::player
