#pragma once

#include "base/hints/keyframe_choice.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/tapestry/tapestry_preview.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"
#include "player/scene/tapestry/tile_cache.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The parts of the canvas that a tapestry uses, canvas px.
struct TapestryBoxes {
    TapestryRoom room;
    Box strip;    // at the bottom of the room's screen, as wide as the canvas
    Box preview;  // above the strip, in the shape of the film's picture; no bezel crosses it
};

/// @param picture  size of the film's upright picture; only its shape counts
TapestryBoxes tapestry_boxes(const TapestryRoom& room, Vec2 picture);

/// The place of a tapestry's strip. Borrows the tapestry.
TapestryPlace strip_place(const Tapestry& tapestry, const TapestryBoxes& boxes);

/// The source numbers of one tapestry, from `first` on.
struct TapestrySources {
    SourceId first = 0;
    unsigned generation = 0;  // of the tapestry, among those of the film that follow each other

    static constexpr unsigned generations = 64;  // then they begin anew

    /// A picture of one white pixel, for drawing lines.
    SourceId mark() const { return first; }

    SourceId tile(const TileId& tile) const;

    /// The first source number for the parts of the film that play.
    SourceId film() const;
};

/// A newer strip that fades in over another one. Lent for the call.
struct OverlaidStrip {
    const Tapestry* tapestry = nullptr;
    const TileCache* tiles = nullptr;
    TapestryView view;
    TapestrySources sources;
    double alpha = 1;
};

/// The parts of a tapestry's frame. Lent for the call.
struct DrawnTapestry {
    const Tapestry& tapestry;
    const TileCache& tiles;
    const TileCache& kept;  // sheets of frames, digits
    const PreviewedFilm& film;
    const TapestryPreview& preview;
    StripPicture touched;  // it plays in place
    TapestryView view;
    TapestryBoxes boxes;
    TapestrySources sources;
    std::optional<OverlaidStrip> coming;
    const KeyframeChoice* edited = nullptr;  // its marks are drawn; none: the keyframes are not edited
};

/// Draws the tapestry, the part that plays in place, the preview above, and a line in the tapestry at the
/// time of the preview. Between two levels it draws the meshes of the zoom fields if the film has them; else
/// one level fades into the other. Where tiles are missing, the coarsest level is drawn. A
/// tapestry that is not woven yet is a pale place. Where keyframes are edited, struck pictures are pale, a
/// bar stands below the strip at each chosen moment and a dash at each struck one.
Frame tapestry_frame(const DrawnTapestry& drawn, std::chrono::nanoseconds now);

}  // namespace vitrine::player
