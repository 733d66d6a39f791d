#pragma once

#include "analyzer/film/frame_source.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/shot_region.hpp"

#include <functional>

namespace vitrine::analyzer {

/// Called with each shot as soon as its region is known. Where it is given, the samples keep their pictures.
using ShotObserver = std::function<void(const ShotEvidence&)>;

/// Called as soon as a film's shot is over, with a record that is not complete and has the new shots alone.
/// Its duration is what the file declares.
using GrowthObserver = std::function<void(const MediaRecord&)>;

/// Applies chapters 3.1 to 3.3 of the paper to one medium, in one pass and bounded memory: finds its shots,
/// what matters in each, and the region around it. A photo is one still frame.
///
/// @param source  at its first frame; frames larger than settings.frame_size help to find faces only
/// @return  kind, size, duration, shots, state ready; the caller adds path, bytes and mtime. Every shot has a
///          region.
/// @throws MediaError if the source breaks or gives no frame at all
/// @throws std::runtime_error if a model's file cannot be read
MediaRecord analyze(FrameSource& source, const AnalysisSettings& settings, const ShotObserver& observer = {},
                    const GrowthObserver& grown = {});

}  // namespace vitrine::analyzer
