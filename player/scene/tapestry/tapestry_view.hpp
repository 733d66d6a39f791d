#pragma once

#include "base/geometry/box.hpp"
#include "base/state/tapestry.hpp"
#include "player/layout/canvas.hpp"
#include "player/layout/layout.hpp"
#include "player/scene/zoom_mesh.hpp"

#include <compare>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vitrine::player {

// The visible part of a tapestry. Between two levels, each moment of the film lies between its places on both
// levels, so that everything moves at a constant speed during a zoom. Source: Video Tapestries 4.3, where
// islands move with constant velocity; here the whole strip does.

struct TapestryView {
    std::chrono::nanoseconds centre{0};  // the film's time in the middle
    double level = 0;                    // in [0, levels - 1]; a whole number: that level alone

    bool operator==(const TapestryView&) const = default;
};

struct TileId {
    std::size_t level = 0;
    int tile = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misreads the 0 inside the default
    auto operator<=>(const TileId&) const = default;
};

/// A part of a tile and its place on the canvas.
struct TilePiece {
    TileId tile;
    double first = 0, last = 1;  // shares of the tile's width
    double left = 0, right = 0;  // canvas px
};

/// The picture of one keyframe in the strip.
struct StripPicture {
    std::chrono::nanoseconds time{0};  // of the keyframe
    bool is_lower = false;             // it stands in the lower row

    bool operator==(const StripPicture&) const = default;
};

/// A canvas, and the part of it that the visitor of a tapestry stands before.
struct TapestryRoom {
    Vec2 canvas;  // px
    Box screen;   // canvas px, of one output, or the whole canvas

    TapestryRoom() = default;

    /// A canvas that is one room.
    TapestryRoom(double width, double height) : TapestryRoom(Vec2{width, height}) {}

    // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a canvas is one room
    TapestryRoom(Vec2 size) : canvas(size), screen{{0, 0}, size} {}

    TapestryRoom(Vec2 size, const Box& seen) : canvas(size), screen(seen) {}

    bool operator==(const TapestryRoom&) const = default;
};

/// The room before the output at a point. A canvas without bezels is one room.
TapestryRoom tapestry_room(const Canvas& canvas, Vec2 at);

/// A tapestry's place in a box of the canvas: its strip is as high as the box. The strip may cross several
/// outputs; the view's moment is in the middle of one of them. Borrows the tapestry, which must outlive this.
class TapestryPlace {
  public:
    /// @param screen  of the output that the visitor stands before, within the box from left to right; none:
    /// the
    ///                whole box
    /// @pre the tapestry has a level, the box is not empty
    TapestryPlace(const Tapestry& tapestry, const Box& box, std::optional<Box> screen = std::nullopt)
        : tapestry_(tapestry), box_(box), screen_(screen.value_or(box)) {}

    /// Width of the whole film at a level, canvas px.
    double width(double level) const;

    double canvas_x(const TapestryView& view, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_at(const TapestryView& view, double canvas_x) const;

    /// The nearest view with as little room beside the film as possible. A film that is narrower than the
    /// screen is in its middle; one that is wider, but not as wide as the box, fills the screen.
    TapestryView bounded(TapestryView view) const;

    /// The view after a move of the strip. @param by  canvas px to the right
    TapestryView moved(const TapestryView& view, double by) const;

    /// The view at another level with the same moment at a canvas point. The level is clamped to the existing
    /// levels.
    TapestryView zoomed(const TapestryView& view, double level, double canvas_x) const;

    /// The difference of level, from this level on, that makes the strip wider by this factor.
    double levels_for(double level, double factor) const;

    /// The parts of a level's tiles between two canvas points, from left to right.
    std::vector<TilePiece> pieces(const TapestryView& view, std::size_t level, double left,
                                  double right) const;

    /// The tiles of a level between two canvas points, with their middles, canvas px. Between two levels with
    /// zoom fields it includes the tiles within a brick's width beyond, because they may reach into the view.
    std::vector<std::pair<TileId, double>> tiles(const TapestryView& view, std::size_t level, double left,
                                                 double right) const;

    /// Scale and origin for drawing a tile's mesh between the two levels around the view's level.
    Placement zoom_placement(const TapestryView& view, const ZoomMesh& mesh) const;

    /// The picture that is drawn at a canvas point, in the row that the point lies in.
    StripPicture picture_at(const TapestryView& view, Vec2 point) const;

    /// The place of a picture, canvas px, about: rows are squeezed into one another.
    /// @param shape  size of the film's upright picture within its bars; only its shape counts
    Box brick(const TapestryView& view, const StripPicture& picture, Vec2 shape) const;

    /// Width of a brick at a whole level, canvas px.
    double brick_width() const { return scale() * tapestry_.brick_width; }

    const Box& box() const { return box_; }

    /// The view's moment is in its middle.
    const Box& screen() const { return screen_; }

    double max_level() const { return static_cast<double>(tapestry_.levels.size() - 1); }

  private:
    double strip_x(double level, std::chrono::nanoseconds time) const;
    std::chrono::nanoseconds time_of(double level, double x) const;

    double scale() const { return box_.height() / tapestry_.height; }

    const Tapestry& tapestry_;  // outlives this
    Box box_;
    Box screen_;
};

/// The view of a tapestry that is most like one of another tapestry of the same film: the same moment in the
/// middle, at about the same scale. A view of one level stays one.
/// @param to, from  in the same box
TapestryView view_like(const TapestryPlace& to, const TapestryPlace& from, const TapestryView& view);

/// The same view of a tapestry at whose level the whole film is so wide elsewhere. If the tapestry is the
/// same there, it is the same view exactly.
/// @param width  canvas px
TapestryView view_of_width(const TapestryPlace& place, const TapestryView& view, double width);

}  // namespace vitrine::player
