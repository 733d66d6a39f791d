#pragma once

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::player {

/// A stretch [begin, end) of a ray.
struct RayStretch {
    double begin = 0;
    double end = 0;
};

/// The side that separates two shapes best: they are clear while normal . apart is at least
/// scale_a * first + scale_b * second + clearance.
struct SeparatingSide {
    Vec2 normal;        // unit length, from a to b
    double first = 0;   // support of shape a along it, source px, > 0
    double second = 0;  // support of shape b against it, source px, > 0
    double slack = 0;   // canvas px beyond clear; negative: the depth
};

/// A scale, or a length of that scale, as a function of the growth g: min(rate * g, limit). The rate of a
/// pinned item is infinite.
struct GrowingScale {
    double rate = 1;
    double limit = 1;

    double at(double g) const { return rate * g < limit ? rate * g : limit; }

    double end() const { return limit / rate; }

    GrowingScale times(double factor) const { return {rate * factor, limit * factor}; }
};

/// The scales of a pair.
struct GrowingScales {
    GrowingScale first, second;
};

/// Places of many items in canvas px, laid out for loops over four at a time: places far away fill up the
/// last four.
struct PlaceLanes {
    std::vector<float> x, y;

    void assign(std::span<const Vec2> places);

    Vec2 at(std::size_t item) const { return {x[item], y[item]}; }

    void set(std::size_t item, Vec2 place) {
        x[item] = static_cast<float>(place.x);
        y[item] = static_cast<float>(place.y);
    }
};

/// Tells whether convex shapes are clear of each other, and how far they can move and grow.
///
/// Two convex shapes overlap exactly when the vector between them lies inside their Minkowski difference,
/// whose sides have the normals of both. So each pair keeps its normals with both supports. The places
/// of the sides follow from the scales, and the depth in which two shapes run into each other is the least
/// distance to a side. Each shape keeps `clearance` from the others.
///
/// Numbers are of single precision, four sides side by side: an answer is true to `precision`. The sides of a
/// pair are made when the pair is first near: most pairs of many items never are. Thread-bound, const or not.
class Contacts {
  public:
    /// canvas px, for canvases of up to 16384 px; all clearances are far above
    static constexpr double precision = 2e-3;

    /// @param clearance  canvas px between any two shapes
    Contacts(std::span<const Shape> shapes, double clearance);

    std::size_t size() const { return size_; }

    double clearance() const { return clearance_; }

    /// @param scales  one a shape, canvas px per source px, > 0
    void set_scales(std::span<const double> scales);

    /// Sets the scale of one shape.
    void set_scale(std::size_t item, double scale);

    /// The shortest distance by which shape `b` must move to be clear of shape `a`, canvas px; 0: they are
    /// clear.
    /// @param apart  place of b minus place of a
    double depth(std::size_t a, std::size_t b, Vec2 apart) const;

    /// True where the shapes are clear of each other as far as `precision` tells.
    bool is_clear(std::size_t a, std::size_t b, Vec2 apart) const { return depth(a, b, apart) <= precision; }

    /// True where shape `item` is clear of all others there.
    bool is_clear(std::size_t item, Vec2 place, std::span<const Vec2> places) const;

    /// Sum over all others j of weights[j] times the depth in which shape `item` at `place` runs into j.
    /// Stops when the sum reaches `enough`.
    double weighted_depth(std::size_t item, Vec2 place, const PlaceLanes& places,
                          std::span<const float> weights, double enough) const;

    /// The shortest move of b that clears it of a; zero where it is clear.
    Vec2 escape(std::size_t a, std::size_t b, Vec2 apart) const;

    SeparatingSide separating_side(std::size_t a, std::size_t b, Vec2 apart) const;

    /// The largest growth at which the two shapes are clear, whatever set_scales() set; 0: at none.
    /// @param scales  of a and b
    /// @param max     returned where they are clear at more
    double max_clear_growth(std::size_t a, std::size_t b, Vec2 apart, const GrowingScales& scales,
                            double max) const;

    /// The part of the ray origin + r * direction, r >= 0, on which shape b is not clear of a shape a that
    /// stands at (0, 0); begin >= end: none.
    RayStretch blocked_stretch(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const;

  private:
    using Lanes = float __attribute__((vector_size(16)));
    static constexpr std::size_t lanes = 4;

    struct Sides {     // four sides of a pair; the last side is repeated where fewer are left
        Lanes x, y;    // unit normals, outward
        Lanes first;   // support of the pair's first shape along it, source px
        Lanes second;  // support of the second shape against it, source px
        Lanes offset;  // a side lies at normal . apart = offset, canvas px
    };

    struct Pair {                          // sides of two shapes a < b
        std::uint32_t begin = 0, end = 0;  // into sides_
    };

    /// The sides of a pair. @pre a != b
    const Pair& pair(std::size_t a, std::size_t b) const {
        const Pair& found = pairs_[a * size_ + b];
        if (found.begin == found.end) add_pair(std::min(a, b), std::max(a, b));
        return found;
    }

    bool is_far(std::size_t a, std::size_t b, float x, float y) const {
        return x * x + y * y >= reach_squared_[a * stride_ + b];
    }

    /// The depth by the sides alone: negative where the shapes are clear. @pre x, y are b's less a's, a < b
    float signed_depth(const Pair& p, float x, float y) const;
    void add_pair(std::size_t a, std::size_t b) const;
    void set_reach(std::size_t a, std::size_t b);
    void set_offsets(std::size_t a, std::size_t b, const Pair& pair) const;

    std::size_t size_;
    std::size_t stride_;  // size, rounded up to whole lanes
    double clearance_;
    std::vector<Polygon> outlines_;
    std::vector<std::vector<Vec2>> normals_;  // normals of the outlines
    std::vector<float> radii_;
    std::vector<float> scales_;
    std::vector<float> reach_squared_;  // at [a * stride + b]: beyond this distance they are clear
    mutable std::vector<Pair> pairs_;   // at [a * size + b] and [b * size + a]; empty: not made yet
    mutable std::vector<Sides> sides_;
};

}  // namespace vitrine::player
