#pragma once

#include "player/layout/cells/seams.hpp"

#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The parts of the canvas that no seam may cut. The owners of seams are the items, then their fillers in the
/// same order.
struct SeamLimits {
    std::vector<Loop> regions;   // one for each item, convex, counter-clockwise; empty: nothing to be kept
    std::vector<Loop> reserves;  // the same with some room around, for seams; empty: the regions themselves
    std::vector<Loops> cores;    // one for each item: boxes; a junction stays in those of its items
};

/// The bounds of some points.
struct Extent {
    std::int64_t left, top, right, bottom;

    /// @pre there is a point
    explicit Extent(std::span<const CellPoint> points);

    bool has(CellPoint p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }

    bool meets(const Extent& other) const {
        return left <= other.right && other.left <= right && top <= other.bottom && other.top <= bottom;
    }
};

/// A bend of a seam, and the triangle that it spans.
struct Bend {
    CellPoint before, at, after;
    int side;  // 1: it turns to the left, -1: to the right, 0: it does not turn
    Extent extent;

    Bend(CellPoint a, CellPoint p, CellPoint b);

    /// True if a point lies in the triangle or on its edges.
    bool has(CellPoint c) const;

    /// True if a point lies inside the bend's angle.
    bool faces(CellPoint c) const;

    /// True if a point lies in the bend's angle or on its legs.
    bool touches(CellPoint c) const;
};

/// 1, 0 or -1.
int sign_of(std::int64_t value);

/// Canvas px.
double distance_between(CellPoint a, CellPoint b);

/// The seams of a canvas and what is between them, for questions about free ways.
class SeamField {
  public:
    /// @param seams, limits  outlive this
    SeamField(std::vector<Seam>& seams, const SeamLimits& limits);

    std::size_t size() const { return seams_.size(); }

    const Seam& seam(std::size_t k) const { return seams_[k]; }

    /// Gives a seam another line.
    void replace(std::size_t k, Loop line);

    /// True if a seam may move: it lies between two items or between two fillers.
    bool is_movable(std::size_t k) const;

    bool is_item(std::size_t owner) const { return owner < limits_.regions.size(); }

    /// The outline that the seams keep out of. Null: the owner has none.
    const Loop* outline_of(std::size_t owner) const;

    /// True if an owner may show what is at a point.
    bool has_pixels(std::size_t owner, CellPoint point) const;

    /// True if seams reach into a bend, apart from its own three points.
    /// @param k, at  the seam of the bend, and its place there
    bool is_crowded(const Bend& bend, std::size_t k, std::size_t at) const;

    /// The corners of the seam's own outlines inside a bend.
    /// @return  none if an outline holds the bend where it is
    std::optional<Loop> corners_in(const Bend& bend, const Seam& seam) const;

    /// True if a stretch meets a seam or an outline, apart from those that begin or end where it does.
    bool is_crossed(CellPoint from, CellPoint to, std::span<const std::size_t> owners) const;

    /// True if a triangle holds a point of a seam or of an outline, apart from its own corners.
    bool is_occupied(const Bend& triangle, std::span<const std::size_t> owners) const;

  private:
    std::vector<Seam>& seams_;  // outlives this
    const SeamLimits& limits_;  // outlives this
    std::vector<Extent> extents_;
};

}  // namespace vitrine::player
