#pragma once

#include "player/layout/shape.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine {

/// A stretch [begin, end) of a ray.
struct Stretch {
    double begin = 0;
    double end = 0;
};

/// Where convex shapes stand clear of each other.
///
/// Two convex shapes overlap exactly when the vector between them lies inside their Minkowski difference,
/// whose sides have the normals of both. So each pair keeps its normals with both supports; the places
/// of the sides follow from the scales, and how deep two shapes run into each other is the least
/// distance to a side. Each shape keeps `clearance` from the others.
class Contacts {
  public:
    /// @param shapes     borrowed for the call only
    /// @param clearance  canvas px between any two shapes
    Contacts(std::span<const Shape> shapes, double clearance);

    std::size_t size() const { return size_; }

    /// @param scales  one a shape, canvas px per source px, > 0
    void set_scales(std::span<const double> scales);

    /// How far shape `b` must move to be clear of shape `a`, canvas px; 0: they are clear.
    /// @param apart  place of b minus place of a
    double depth(std::size_t a, std::size_t b, Vec2 apart) const;

    /// The shortest move of b that clears it of a; zero where it is clear.
    Vec2 escape(std::size_t a, std::size_t b, Vec2 apart) const;

    /// The stretch of the ray origin + r * direction, r >= 0, on which shape b is not clear of a shape a at
    /// the origin of coordinates; begin >= end: none.
    Stretch blocked(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const;

  private:
    struct Side {
        Vec2 normal;        // unit length, outward
        double first = 0;   // support of the pair's first shape along it, source px
        double second = 0;  // support of the second shape against it, source px
    };

    struct Pair {
        std::size_t begin = 0, end = 0;  // into sides_ and offsets_
        double reach_squared = 0;        // beyond this distance the shapes are clear
    };

    const Pair& pair(std::size_t a, std::size_t b) const { return pairs_[a * size_ + b]; }

    void add_pair(const Shape& first, const Shape& second);

    std::size_t size_;
    double clearance_;
    std::vector<double> radii_;
    std::vector<Side> sides_;
    std::vector<double> offsets_;  // a side lies at normal . apart = offset
    std::vector<Pair> pairs_;      // of [a * size + b], for a != b
};

}  // namespace vitrine
