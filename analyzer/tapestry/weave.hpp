#pragma once

#include "analyzer/tapestry/retarget.hpp"

#include <functional>

namespace vitrine {

/// Weaves one level of a tapestry from left to right, tile by tile, each in agreement with the one before.
/// Holds no more than a tile at a time, however long the film is.
///
/// @param keyframe  gives the keyframe of that number, [0, brickwork.keyframes)
/// @param sink      is given the finished columns, CV_8UC3, tapestry_height() tall, all in all
///                  brickwork.width() of them
void weave_level(const Brickwork& brickwork, const std::function<Keyframe(int)>& keyframe,
                 const std::function<void(const cv::Mat&)>& sink, const RetargetSettings& settings = {},
                 const RunTasks& run = run_in_order);

}  // namespace vitrine
