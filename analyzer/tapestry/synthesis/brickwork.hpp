#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

/// Keyframes in two rows: those of even number above, those of odd number below, half a brick further right.
/// So the middles of keyframes one after another are half a brick apart.
/// Source: Video Tapestries 4.2, figure 4.
struct Brickwork {
    int keyframes = 0;  // at least 1; a single one stands in both rows
    cv::Size brick;     // px, its width even

    int bricks() const { return keyframes == 1 ? 2 : keyframes; }

    int width() const { return (bricks() + 1) * brick.width / 2; }

    int height() const { return 2 * brick.height; }

    cv::Rect place(int number) const {
        return {number * brick.width / 2, (number & 1) * brick.height, brick.width, brick.height};
    }

    /// The first brick that reaches beyond x, and the first that begins at it or behind; half bricks at the
    /// ends count to their neighbours.
    int first_at(int x) const;
    int last_at(int x) const;
};

struct Keyframe {
    cv::Mat picture;              // CV_8UC3, of the brick's size
    std::vector<cv::Rect> faces;  // px of it
};

/// Bricks one after another, with the brickwork that they are of.
struct BrickSection {
    Brickwork brickwork;
    std::vector<Keyframe> bricks;  // keyframes of the bricks number `first`, `first` + 1 ...
    int first = 0;
};

/// The part of a tapestry that is made at once.
struct TileSpan {
    int from = 0;  // px of the strip
    int to = 0;
};

/// A part of the brickwork, made smaller, of which a tile is made.
struct BrickWindow {
    PatchImage picture;  // with half bricks at the strip's ends filled by mirrored neighbours
    PatchRules rules;
};

struct WindowSettings {
    int face_weight = 4;     // of patches that touch a face; others have 1. Ours: 4.2 only says "increase"
    double time_cost = 400;  // squared grey levels at half a brick further from the keyframe's middle
};

/// @param section  all bricks that lie in the window
/// @param tile     the window reaches half a brick further where there is more
/// @param scale    (0, 1]
/// Patches of the tile have weight, those of the margins may be used and need not. Time costs nothing within
/// a brick of its own middle, then the square of the distance: eq. 2 with tau(x) straight from keyframe to
/// keyframe, in units of keyframes.
BrickWindow brick_window(const BrickSection& section, const TileSpan& tile, double scale,
                         const WindowSettings& settings = {});

/// The begin and the end of a tile's window, px of the brickwork.
cv::Range window_of(const Brickwork& brickwork, const TileSpan& tile);

}  // namespace vitrine::analyzer
