#include "player/layout/contacts.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace vitrine {

namespace {

double support(const Polygon& outline, Vec2 direction) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec2& p : outline)
        most = std::max(most, dot(p, direction));
    return most;
}

/// Outward unit normals of a counter-clockwise outline.
std::vector<Vec2> normals(const Polygon& outline) {
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 edge = outline[(i + 1) % outline.size()] - outline[i];
        result.push_back(Vec2{edge.y, -edge.x} * (1 / length(edge)));
    }
    return result;
}

}  // namespace

Contacts::Contacts(std::span<const Shape> shapes, double clearance)
    : size_(shapes.size()), clearance_(clearance) {
    for (const Shape& shape : shapes)
        radii_.push_back(shape.radius);
    for (std::size_t a = 0; a < size_; ++a)
        for (std::size_t b = 0; b < size_; ++b) {
            const std::size_t begin = sides_.size();
            if (a != b) add_pair(shapes[a], shapes[b]);
            pairs_.push_back({begin, sides_.size()});
        }
    offsets_.resize(sides_.size());
}

void Contacts::add_pair(const Shape& first, const Shape& second) {
    for (const Vec2& n : normals(first.outline))
        sides_.push_back({n, support(first.outline, n), support(second.outline, n * -1)});
    for (const Vec2& n : normals(second.outline))
        sides_.push_back({n * -1, support(first.outline, n * -1), support(second.outline, n)});
}

void Contacts::set_scales(std::span<const double> scales) {
    assert(scales.size() == size_);
    for (std::size_t a = 0; a < size_; ++a)
        for (std::size_t b = 0; b < size_; ++b) {
            Pair& p = pairs_[a * size_ + b];
            for (std::size_t k = p.begin; k < p.end; ++k)
                offsets_[k] = scales[a] * sides_[k].first + scales[b] * sides_[k].second + clearance_;
            // The clearance is added to each side, so it grows at the corners; those are cut off here.
            const double reach = scales[a] * radii_[a] + scales[b] * radii_[b] + clearance_;
            p.reach_squared = reach * reach;
        }
}

double Contacts::depth(std::size_t a, std::size_t b, Vec2 apart) const {
    const Pair& p = pair(a, b);
    if (dot(apart, apart) >= p.reach_squared) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const double inside = offsets_[k] - dot(sides_[k].normal, apart);
        if (inside <= 0) return 0;
        least = std::min(least, inside);
    }
    return least;
}

Vec2 Contacts::escape(std::size_t a, std::size_t b, Vec2 apart) const {
    const Pair& p = pair(a, b);
    if (dot(apart, apart) >= p.reach_squared) return {};
    double least = std::numeric_limits<double>::infinity();
    Vec2 way;
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const double inside = offsets_[k] - dot(sides_[k].normal, apart);
        if (inside <= 0) return {};
        if (inside < least) way = sides_[k].normal;
        least = std::min(least, inside);
    }
    return way * least;
}

Stretch Contacts::blocked(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const {
    const Pair& p = pair(a, b);
    Stretch inside{0, std::numeric_limits<double>::infinity()};
    for (std::size_t k = p.begin; k < p.end; ++k) {
        const double speed = dot(sides_[k].normal, direction);
        const double room = offsets_[k] - dot(sides_[k].normal, origin);
        if (speed == 0 && room <= 0) return {};
        if (speed > 0) inside.end = std::min(inside.end, room / speed);
        if (speed < 0) inside.begin = std::max(inside.begin, room / speed);
        if (inside.begin >= inside.end) return {};
    }
    return inside;
}

}  // namespace vitrine
