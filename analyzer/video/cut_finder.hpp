#pragma once

#include "analyzer/video/feature_window.hpp"

namespace vitrine {

/// So long after a frame must be known before it can be judged.
constexpr std::chrono::milliseconds cut_radius{240};
constexpr std::size_t cut_radius_frames = 4;  // at least so many, where frames are rare

/// Whether a new shot begins with `frame`: its colour difference to the frame before is the largest around it
/// and stands out, and what follows stays different from what went before, which a flash's does not.
///
/// Source: Lienhart's CHD (Dynamic Media Assemblage 3.1). Differs: an adaptive threshold and the flash guard.
bool is_cut(const FeatureWindow& window, std::size_t frame);

}  // namespace vitrine
