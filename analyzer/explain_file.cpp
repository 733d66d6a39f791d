#include "analyzer/explain_file.hpp"

#include "analyzer/analyze.hpp"

namespace vitrine {
namespace {

constexpr std::size_t most_rows = 6;

}  // namespace

MediaRecord write_explain_sheet(FrameSource& source, const SheetTitle& title, const std::string& output,
                                const AnalysisSettings& settings) {
    LongestShots rows(most_rows);
    MediaRecord record =
        analyze(source, settings, [&rows](const ShotEvidence& evidence) { rows.add(evidence); });
    drawn_sheet(title, record, rows.shots()).write_png(output);
    return record;
}

}  // namespace vitrine
