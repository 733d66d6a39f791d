#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

/// Keyframes in two rows: even numbers above, odd numbers below and half a brick further right. So the
/// middles of consecutive keyframes are half a brick apart.
/// Source: Video Tapestries 4.2, figure 4.
struct Brickwork {
    int keyframes = 0;  // at least 1; a single one stands alone, as tall as the tapestry
    cv::Size brick;     // px, its width even

    int bricks() const { return keyframes == 1 ? 2 : keyframes; }

    int width() const { return (bricks() + 1) * brick.width / 2; }

    int height() const { return 2 * brick.height; }

    cv::Rect place(int number) const {
        return {number * brick.width / 2, (number & 1) * brick.height, brick.width, brick.height};
    }

    /// first_at() is the first brick that reaches beyond x; last_at() is the first one that begins at x or
    /// behind it. Half bricks at the ends belong to their neighbours.
    int first_at(int x) const;
    int last_at(int x) const;
};

struct Keyframe {
    cv::Mat picture;              // CV_8UC3, of the brick's size
    std::vector<cv::Rect> faces;  // px of the picture
    std::vector<cv::Point>
        region;  // convex, px of the picture: what matters in it; empty: not known, or nearly all
};

/// Consecutive bricks, and the brickwork that they belong to.
struct BrickSection {
    Brickwork brickwork;
    std::vector<Keyframe> bricks;  // keyframes of the bricks `first`, `first` + 1, ...
    int first = 0;
};

/// The columns [from, to) of a tapestry that are made at once.
struct TileSpan {
    int from = 0;  // px of the strip
    int to = 0;
};

/// A scaled part of the brickwork, from which a tile is made.
struct BrickWindow {
    PatchImage picture;  // the margins of their neighbours fill the half bricks at the strip's ends
    PatchRules rules;
};

struct WindowSettings {
    int face_weight = 4;     // weight of patches at a face; others have 1. Ours: 4.2 only says "increase"
    int region_weight = 4;   // weight of patches in the region; see section 7 of the paper
    double time_cost = 400;  // squared grey levels a channel value, half a brick beyond `reach`
};

/// Draws the bricks of a tile and of its margins at a scale. Patches of the tile have weight; those of the
/// margins may be used, but need not. A patch has no cost of time within half a brick of its brick's middle,
/// then one by the square of the distance: eq. 2 with tau(x) linear from keyframe to keyframe, in units of
/// keyframes.
///
/// @param section  all bricks that lie in the window
/// @param tile     the window reaches half a brick further where there is more
/// @param scale    (0, 1]
BrickWindow brick_window(const BrickSection& section, const TileSpan& tile, double scale,
                         const WindowSettings& settings = {});

/// The columns of a tile's window, px of the brickwork.
cv::Range window_of(const Brickwork& brickwork, const TileSpan& tile);

}  // namespace vitrine::analyzer
