#pragma once

#include "base/geometry/box.hpp"

#include <span>
#include <vector>

namespace vitrine::analyzer {

/// The lines of text that one search in a shot has found.
struct LineSearch {
    double time = 0;  // seconds since the shot's begin
    std::vector<Box> lines;
};

/// The lines of a shot, without those that only one search of several has found, for a detector errs now and
/// then. A line may stand still or go along with the drift.
/// @param drift  per second
/// @return       the lines at their places at the shot's begin, one for each time that they were found
std::vector<Box> steady_lines(std::span<const LineSearch> searches, Vec2 drift);

/// True where a line stands still although the drift would have moved it by more than half its height: a
/// caption over a picture that pans.
bool has_caption(std::span<const LineSearch> searches, Vec2 drift);

}  // namespace vitrine::analyzer
