#pragma once

#include "base/geometry/vec2.hpp"

#include <algorithm>

namespace vitrine {

/// An axis-parallel rectangle. It is empty if max is not beyond min in both axes.
struct Box {
    Vec2 min;
    Vec2 max;

    double width() const { return std::max(0.0, max.x - min.x); }

    double height() const { return std::max(0.0, max.y - min.y); }

    double area() const { return width() * height(); }

    Vec2 centre() const { return (min + max) * 0.5; }

    bool is_empty() const { return max.x <= min.x || max.y <= min.y; }

    bool operator==(const Box&) const = default;
};

inline Box intersection(const Box& a, const Box& b) {
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// Intersection over union, in [0, 1].
inline double overlap(const Box& a, const Box& b) {
    const double both = intersection(a, b).area();
    return both > 0 ? both / (a.area() + b.area() - both) : 0;
}

inline Box united(const Box& a, const Box& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

inline Box moved(const Box& box, Vec2 by) {
    return {box.min + by, box.max + by};
}

}  // namespace vitrine
