#pragma once

#include "base/geometry/box.hpp"
#include "base/state/tapestry.hpp"
#include "player/layout/layout.hpp"
#include "player/scene/zoom_mesh.hpp"

#include <compare>
#include <cstddef>
#include <utility>
#include <vector>

namespace vitrine::player {

// Which part of a tapestry is seen. Between two levels a moment of the film lies between its places on both,
// so that while one zooms everything moves at a constant speed. Source: Video Tapestries 4.3, where islands
// move with constant velocity; here all of the strip does.

struct TapestryView {
    std::chrono::nanoseconds centre{0};  // what is seen in the middle
    double level = 0;                    // in [0, levels - 1]; a whole number: that level alone

    friend bool operator==(const TapestryView&, const TapestryView&) = default;
};

struct TileId {
    std::size_t level = 0;
    int tile = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    friend auto operator<=>(const TileId&, const TileId&) = default;
};

/// A part of a tile, where it is seen.
struct TilePiece {
    TileId tile;
    double first = 0, last = 1;  // of the tile, as shares of its width
    double left = 0, right = 0;  // canvas px
};

/// A tapestry as it lies in a box of the canvas, which is as high as the strip is drawn. Lent: the tapestry
/// must outlive this.
class TapestryPlace {
  public:
    /// @pre the tapestry has a level, the box is not empty
    TapestryPlace(const Tapestry& tapestry, const Box& box) : tapestry_(tapestry), box_(box) {}

    /// Of the whole film, canvas px.
    double width(double level) const;

    double canvas_x(const TapestryView& view, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_at(const TapestryView& view, double canvas_x) const;

    /// The nearest view that shows no more beside the film than it must.
    TapestryView bounded(TapestryView view) const;

    /// The strip goes with a finger. @param by  canvas px to the right
    TapestryView moved(const TapestryView& view, double by) const;

    /// Another level, the same moment at a canvas point. Levels that there are not become the nearest.
    TapestryView zoomed(const TapestryView& view, double level, double canvas_x) const;

    /// How many levels nearer the strip is once it is so many times as wide, from here.
    double levels_for(double level, double factor) const;

    /// All of a level that lies between two canvas points, from left to right.
    std::vector<TilePiece> pieces(const TapestryView& view, std::size_t level, double left,
                                  double right) const;

    /// The same, whole tiles only: with their middles, canvas px. Between two levels with zoom fields these
    /// are all that may reach in, which is those of a brick's width more.
    std::vector<std::pair<TileId, double>> tiles(const TapestryView& view, std::size_t level, double left,
                                                 double right) const;

    /// Where a tile's points are counted from on their way between the levels around the view's, and canvas
    /// px a px.
    Placement zoom_placement(const TapestryView& view, const ZoomMesh& mesh) const;

    /// Of a brick, canvas px at a whole level.
    double brick_width() const { return scale() * tapestry_.brick_width; }

    const Box& box() const { return box_; }

    double most_level() const { return static_cast<double>(tapestry_.levels.size() - 1); }

  private:
    bool goes_over(const TapestryView& view, std::size_t level) const;
    double strip_x(double level, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_of(double level, double x) const;

    double scale() const { return box_.height() / tapestry_.height; }

    const Tapestry& tapestry_;  // outlives this
    Box box_;
};

}  // namespace vitrine::player
