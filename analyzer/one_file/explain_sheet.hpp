#pragma once

#include "analyzer/explain/canvas.hpp"
#include "analyzer/explain/sheet.hpp"
#include "analyzer/film/frame_source.hpp"
#include "analyzer/saliency/analysis_settings.hpp"

#include <functional>
#include <memory>

namespace vitrine::analyzer {

using SourceOpener = std::function<std::unique_ptr<FrameSource>()>;

/// The sheet that explains what was seen in a medium, and the record, as analyze() makes it.
struct Explanation {
    MediaRecord record;
    Canvas sheet;
};

/// Analyses a medium and draws its sheet: `vitrine-analyzer explain FILE`.
///
/// @param open    opens it from its first frame, as open_media() does; called twice, because the medium is
///                analysed by the paper's letter too, to show both
/// @throws as analyze(); std::runtime_error if the sheet cannot be drawn
Explanation explain(const SourceOpener& open, const SheetTitle& title, const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
