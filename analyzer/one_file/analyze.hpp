#pragma once

#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "analyzer/video/frame_source.hpp"

#include <functional>

namespace vitrine::analyzer {

/// Sees each shot as soon as its region is known. Where there is one, pictures are kept with the samples.
using ShotObserver = std::function<void(const ShotEvidence&)>;

/// Sees what is new of a film as soon as a shot is over: a record that is not complete, of the new shots
/// alone. Its duration is what the file says of itself.
using GrowthObserver = std::function<void(const MediaRecord&)>;

/// Chapter 3.1 to 3.3 of the paper over one medium, in one pass and bounded memory: shots, what matters in
/// each, and the region around it. A photo is one still frame.
///
/// @param source  from its first frame; its frames may be larger than settings.frame_size: only faces gain
/// @return  kind, size, duration, shots, state ready; path, bytes and mtime are the caller's. Every shot has
/// a region.
/// @throws MediaError if the source breaks or gives no frame at all
/// @throws std::runtime_error if a face detector's file cannot be read
MediaRecord analyze(FrameSource& source, const AnalysisSettings& settings, const ShotObserver& observer = {},
                    const GrowthObserver& grown = {});

}  // namespace vitrine::analyzer
