#pragma once

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vitrine::player {

/// A part [begin, end) of a ray.
struct RayStretch {
    double begin = 0;
    double end = 0;
};

/// The side that separates two shapes best. They are clear if normal . apart is at least scale_a * first +
/// scale_b * second + clearance.
struct SeparatingSide {
    Vec2 normal;        // unit length, from a to b
    double first = 0;   // support of shape a along it, source px, > 0
    double second = 0;  // support of shape b against it, source px, > 0
    double slack = 0;   // canvas px more than needed to be clear; negative: the depth of the overlap
};

/// A scale, or a length in proportion to it, as a function of the growth g: min(rate * g, limit). A pinned
/// item's rate is infinite.
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

/// Places of many items in canvas px, arranged for loops over four at a time. Places far away fill up the
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

/// Tells if convex shapes are clear of each other, and how far they can move and grow.
///
/// Two convex shapes overlap exactly if the vector between them lies inside their Minkowski difference, whose
/// sides have the normals of both shapes. So each pair keeps its normals with both supports. The scales give
/// the places of the sides. The depth of an overlap is the smallest distance to a side. Each shape keeps
/// `clearance` from the others.
///
/// Numbers are of single precision, four sides at a time: answers are exact to `precision`. The sides of a
/// pair are computed when the pair is first near, because most pairs of many items never are. Thread-bound,
/// even if const.
class Contacts {
  public:
    /// canvas px, for canvases of up to 16384 px; far below all clearances
    static constexpr double precision = 2e-3;

    /// @param clearance  canvas px between any two shapes
    Contacts(std::span<const Shape> shapes, double clearance);

    std::size_t size() const { return size_; }

    double clearance() const { return clearance_; }

    /// @param scales  one for each shape, canvas px per source px, > 0
    void set_scales(std::span<const double> scales);

    /// Sets the scale of one shape.
    void set_scale(std::size_t item, double scale);

    /// The shortest move of shape `b` that makes it clear of shape `a`, canvas px; 0: they are clear.
    /// @param apart  place of b minus place of a
    double depth(std::size_t a, std::size_t b, Vec2 apart) const;

    /// True if the shapes are clear of each other, to `precision`.
    bool is_clear(std::size_t a, std::size_t b, Vec2 apart) const { return depth(a, b, apart) <= precision; }

    /// True if shape `item` at this place is clear of all others.
    bool is_clear(std::size_t item, Vec2 place, std::span<const Vec2> places) const;

    /// The sum over all others j of weights[j] times the depth of the overlap of shape `item` at `place` with
    /// j. Stops when the sum reaches `enough`.
    double weighted_depth(std::size_t item, Vec2 place, const PlaceLanes& places,
                          std::span<const float> weights, double enough) const;

    /// The shortest move of b that makes it clear of a; zero if it is clear.
    Vec2 escape(std::size_t a, std::size_t b, Vec2 apart) const;

    SeparatingSide separating_side(std::size_t a, std::size_t b, Vec2 apart) const;

    /// The largest growth at which the two shapes are clear, independent of set_scales(); 0: there is none.
    /// @param scales  the scales of a and b
    /// @param max     upper limit of the result
    double max_clear_growth(std::size_t a, std::size_t b, Vec2 apart, const GrowingScales& scales,
                            double max) const;

    /// The part of the ray origin + r * direction, r >= 0, on which shape b is not clear of a shape a at (0,
    /// 0). begin >= end: it is clear everywhere.
    RayStretch blocked_stretch(std::size_t a, std::size_t b, Vec2 origin, Vec2 direction) const;

  private:
    using Lanes = float __attribute__((vector_size(16)));
    static constexpr std::size_t lanes = 4;

    struct Sides {     // four sides of a pair; the last four repeat the last side
        Lanes x, y;    // unit normals, outward
        Lanes first;   // support of the pair's first shape along the normal, source px
        Lanes second;  // support of the second shape against the normal, source px
        Lanes offset;  // the side lies at normal . apart = offset, canvas px
    };

    struct Pair {                          // the sides of two shapes a < b
        std::uint32_t begin = 0, end = 0;  // indices in sides_
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

    /// The depth from the sides alone; negative if the shapes are clear. @pre x, y: place of b minus place of
    /// a, a < b
    float signed_depth(const Pair& p, float x, float y) const;
    void add_pair(std::size_t a, std::size_t b) const;
    void set_reach(std::size_t a, std::size_t b);
    void set_offsets(std::size_t a, std::size_t b, const Pair& pair) const;

    std::size_t size_;
    std::size_t stride_;  // the number of shapes, rounded up to whole lanes
    double clearance_;
    std::vector<Polygon> outlines_;
    std::vector<std::vector<Vec2>> normals_;  // normals of the outlines
    std::vector<float> radii_;
    std::vector<float> scales_;
    std::vector<float> reach_squared_;  // at [a * stride + b]: farther apart than this they are clear
    mutable std::vector<Pair> pairs_;   // at [a * size + b] and [b * size + a]; empty: not computed yet
    mutable std::vector<Sides> sides_;
};

}  // namespace vitrine::player
