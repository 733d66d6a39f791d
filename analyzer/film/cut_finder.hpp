#pragma once

#include "analyzer/film/take_change.hpp"

namespace vitrine::analyzer {

/// So long after a frame must be known before it can be judged.
constexpr std::chrono::milliseconds cut_horizon = longest_return;

/// Says if a new shot begins with `frame`: the picture changes at once, no motion explains the change, and
/// what follows is another take.
///
/// Source: Lienhart's CHD (Dynamic Media Assemblage 3.1). Differs: the change is measured at the place as
/// well, compensated for motion and set against its surroundings; flashes and things passing by are no cuts.
bool is_cut(const FeatureWindow& window, std::size_t frame);

}  // namespace vitrine::analyzer
