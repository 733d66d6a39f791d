#pragma once

#include "analyzer/tapestry/synthesis/retarget.hpp"

#include <functional>

namespace vitrine::analyzer {

/// How far the weaving of a level has come.
struct WovenSoFar {
    std::size_t tiles = 0;  // of tile_spans() that are done
    cv::Mat border;         // CV_8UC3, tile_overlap wide: the begin of the next one; empty where none is done
};

/// Is given finished columns, CV_8UC3, tapestry_height() tall, and how far the level is with them.
using ColumnSink = std::function<void(const cv::Mat& columns, const WovenSoFar& done)>;

/// Weaves one level of a tapestry from left to right, tile by tile, each in agreement with the one before.
/// Holds no more than a tile at a time, however long the film is.
///
/// @param keyframe  gives the keyframe of that number, [0, brickwork.keyframes)
/// @param sink      gets from WovenSoFar::tiles' begin on all columns up to brickwork.width()
/// @param done      what an earlier weaving of the same level was given: it goes on there, and what comes
///                  does not depend on where that was
void weave_level(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe,
                 const ColumnSink& sink, const RetargetSettings& settings = {},
                 const RunTasks& run = run_in_order, WovenSoFar done = {});

}  // namespace vitrine::analyzer
