#pragma once

#include "analyzer/tapestry/synthesis/retarget.hpp"

#include <functional>

namespace vitrine::analyzer {

/// The progress of weaving a level.
struct WovenSoFar {
    std::size_t tiles = 0;  // of tile_spans() that are done
    cv::Mat border;         // CV_8UC3, tile_overlap wide: the begin of the next one; empty where none is done
};

/// The bricks of a level, and where their keyframes come from.
struct LevelBricks {
    Brickwork brickwork;
    std::function<Keyframe(int)> keyframe;  // gives the keyframe of that number, [0, brickwork.keyframes)
};

/// Is given finished columns, CV_8UC3, tapestry_height() tall, and how far the level is with them.
using ColumnSink = std::function<void(const cv::Mat& columns, const WovenSoFar& done)>;

/// Weaves one level of a tapestry from left to right, tile by tile, each in agreement with the one before.
/// Holds no more than a tile at a time, however long the film is.
///
/// @param sink  gets from WovenSoFar::tiles' begin on all columns up to brickwork.width()
/// @param done  the place that an earlier weaving of the same level had reached: it goes on there, and the
///              columns that follow do not depend on where that was
void weave_level(const LevelBricks& bricks, const ColumnSink& sink, const RetargetSettings& settings = {},
                 const RunTasks& run = run_in_order, WovenSoFar done = {});

}  // namespace vitrine::analyzer
