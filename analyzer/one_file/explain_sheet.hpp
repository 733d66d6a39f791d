#pragma once

#include "analyzer/explain/sheet.hpp"
#include "analyzer/film/frame_source.hpp"
#include "analyzer/saliency/analysis_settings.hpp"

#include <functional>
#include <memory>
#include <string>

namespace vitrine::analyzer {

using SourceOpener = std::function<std::unique_ptr<FrameSource>()>;

/// Analyses a medium and writes the sheet that explains what was seen, as PNG: `vitrine-analyzer explain
/// FILE`.
///
/// @param open    opens it from its first frame, as open_media() does; called twice, because the medium is
///                analysed by the paper's letter too, to show both
/// @param output  path of the PNG
/// @return        the record, as analyze() makes it
/// @throws as analyze(); std::runtime_error if the sheet cannot be drawn or written
MediaRecord write_explain_sheet(const SourceOpener& open, const SheetTitle& title, const std::string& output,
                                const AnalysisSettings& settings);

}  // namespace vitrine::analyzer
