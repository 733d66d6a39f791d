#pragma once

#include "analyzer/saliency/sample.hpp"
#include "base/geometry/box.hpp"

#include <chrono>
#include <vector>

namespace vitrine::analyzer {

/// The things that clearly move by themselves in a shot, as boxes moved to their places at the shot's begin:
/// a subject that runs through the picture is outside the saliency on average, and still must not be cut. A
/// mover is a spot of strong motion contrast, neither a speck nor most of the picture, that the sample before
/// or after shows nearby. Where many things move, as in a street, all of them count.
///
/// @param drift  px of the map per second
/// @return       px of the map; may reach beyond it
std::vector<Box> movers(const std::vector<Sample>& samples, std::chrono::nanoseconds begin, Vec2 drift);

}  // namespace vitrine::analyzer
