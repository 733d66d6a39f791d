#pragma once

#include "analyzer/explain/canvas.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "base/state/record.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace vitrine::analyzer {

constexpr int time_line_height = 92;  // canvas px

/// "1:02:03.4", "2:03.4" or "3.4 s".
std::string time_text(std::chrono::nanoseconds time);

/// Draws all shots of a film from left to right, numbered, dissolves and fades between them in their colours,
/// the rows of the sheet in another, and a scale in time below.
void draw_time_line(Canvas& canvas, const Box& place, const MediaRecord& record,
                    const std::vector<ShotEvidence>& rows);

}  // namespace vitrine::analyzer
