#pragma once

#include "analyzer/film/take_change.hpp"

namespace vitrine::analyzer {

/// Frames up to so long after a frame must be known before the frame can be judged.
constexpr std::chrono::milliseconds cut_horizon = max_return;

/// Says if a new shot begins with `frame`: the picture changes at once, no motion explains the change, and
/// another take follows.
///
/// Source: Lienhart's CHD (Dynamic Media Assemblage 3.1). Differs: the change is also measured place by
/// place, compensated for motion and compared with the changes around it; flashes and passing things are no
/// cuts.
bool is_cut(const FeatureWindow& window, std::size_t frame);

}  // namespace vitrine::analyzer
