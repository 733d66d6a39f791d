#pragma once

#include <cmath>

namespace vitrine {

/// A point or a displacement, x to the right, y down. Each use names its unit.
struct Vec2 {
    double x = 0;
    double y = 0;

    bool operator==(const Vec2&) const = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}

inline Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}

inline Vec2 operator*(Vec2 a, double s) {
    return {a.x * s, a.y * s};
}

inline double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

/// z of the cross product: positive when b lies on the positive-angle side of a.
inline double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

inline double length(Vec2 a) {
    return std::sqrt(dot(a, a));
}

}  // namespace vitrine
