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

/// Draws all shots of a film from left to right with their numbers, and a time scale below. Dissolves, fades
/// and the shots of the rows of the sheet have colours of their own.
void draw_time_line(Canvas& canvas, const Box& place, const MediaRecord& record,
                    const std::vector<ShotEvidence>& rows);

}  // namespace vitrine::analyzer
