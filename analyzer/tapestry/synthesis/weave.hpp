#pragma once

#include "analyzer/tapestry/synthesis/retarget.hpp"

#include <functional>

namespace vitrine::analyzer {

/// The progress of weaving a level.
struct WovenSoFar {
    std::size_t tiles = 0;  // finished tiles of tile_spans()
    cv::Mat border;         // CV_8UC3, tile_overlap wide: begin of the next tile; empty before the first
};

/// The bricks of a level, and where their keyframes come from.
struct LevelBricks {
    Brickwork brickwork;
    std::function<Keyframe(int)> keyframe;  // returns the keyframe of a number in [0, brickwork.keyframes)
};

/// Receives finished columns, CV_8UC3, tapestry_height() tall, and the progress that includes them.
using ColumnSink = std::function<void(const cv::Mat& columns, const WovenSoFar& done)>;

/// Weaves one level of a tapestry from left to right, tile by tile, each in agreement with the one before.
/// Holds no more than a tile at a time, however long the film is.
///
/// @param sink  receives all columns from the begin of the first unfinished tile up to brickwork.width()
/// @param done  the progress of an earlier weaving of the same level, which goes on there; the columns do not
///              depend on where it was interrupted
void weave_level(const LevelBricks& bricks, const ColumnSink& sink, const RetargetSettings& settings = {},
                 const RunTasks& run = run_in_order, WovenSoFar done = {});

}  // namespace vitrine::analyzer
