#pragma once

#include "base/geometry/box.hpp"
#include "base/geometry/polygon.hpp"
#include "player/layout/cells/cells.hpp"
#include "player/scene/zoom_mesh.hpp"
#include "player/words/word_item.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace vitrine::player {

/// The number of a playing shot for as long as it is on the wall. Never used twice.
using SourceId = std::uint64_t;

/// The brightness of filler on a wall that stands: a frame, not a second picture.
inline constexpr double usual_filler_light = 0.3;

/// One cell of a frame, plain data.
struct DrawItem {
    SourceId source = 0;
    std::shared_ptr<const Cell> cell;      // shared by all frames of a layout
    std::shared_ptr<const ZoomMesh> zoom;  // instead of a cell: canvas = scale * strip px + offset; shared
    double share = 0;                      // position between the two places of the mesh's points, [0, 1]
    Placement placement;                   // canvas = source px * scale + offset, at the shot's start
    Vec2 picture;                          // size of the upright source picture, source px
    Box active;                            // its part within its bars, source px; empty: all of it
    std::chrono::nanoseconds local{0};     // since the shot first appeared; it plays in a loop
    double alpha = 1;                      // opacity over the items drawn before it, [0, 1]
    double filler_light = usual_filler_light;  // brightness of the cell's filler, as a share of the picture's
    double slide_share = 1;                    // share of the picture's slide (Sample) that is drawn, [0, 1]
};

/// A plain white box, for the rim of something above the wall.
struct Plate {
    Box box;                // canvas px
    std::size_t below = 0;  // it is drawn before the item with this number

    bool operator==(const Plate&) const = default;
};

/// A name above the wall. Once there is a picture of it, it is drawn as a word.
struct FrameName {
    std::string text;
    Box box;  // canvas px: its line, where nothing matters
    double alpha = 1;

    bool operator==(const FrameName&) const = default;
};

/// The room for a shot's caption. While the wall changes, only a shot that stays where it is has one.
struct CaptionRoom {
    SourceId source = 0;
    std::string path;                    // of the shot's file
    std::shared_ptr<const Cell> cell;    // shared by all frames of a layout
    std::shared_ptr<const Cell> next{};  // its cell after the change; null: the wall stands
    Polygon region;                      // canvas px: holds the I-Region wherever it drifts; convex
    std::vector<Box> avoided{};          // canvas px: bezels, and faces and lines of text wherever they drift

    bool operator==(const CaptionRoom&) const = default;
};

/// The content of one refresh of a screen, in the order of drawing; testable without GL.
struct Frame {
    Vec2 canvas;  // px
    Vec2 view;    // canvas point at the top left, px; moves if the wall is wider than the screen
    std::vector<DrawItem> items;
    std::vector<Plate> plates;
    std::vector<WordItem> words;          // above all items
    std::vector<FrameName> names;         // whose pictures become `words`
    std::vector<CaptionRoom> captions{};  // whose captions become `words`
    std::vector<Box> covered;  // canvas px: boxes that the items cover completely, if all can be drawn
    double idle = 0;           // opacity of the idle picture drawn first, in [0, 1]
    bool is_fade = false;      // true: there need be no opaque item, and `idle` holds nevertheless
    std::chrono::nanoseconds time{0};  // since the player started
};

/// True if both look the same as long as the sources' pictures are the same: they may differ in times only.
bool looks_alike(const Frame& a, const Frame& b);

}  // namespace vitrine::player
