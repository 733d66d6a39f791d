#include "analyzer/one_file/explain_sheet.hpp"

#include "analyzer/one_file/analyze.hpp"

#include <utility>

namespace vitrine::analyzer {
namespace {

constexpr std::size_t max_rows = 6;

/// The region of the shot that begins then: the same shots are found with every kind of saliency.
IRegion region_from(const MediaRecord& record, std::chrono::nanoseconds begin) {
    for (const Shot& shot : record.shots) {
        if (shot.begin == begin) return shot.region;
    }
    return {};
}

}  // namespace

Explanation explain(const SourceOpener& open, const SheetTitle& title, const AnalysisSettings& settings) {
    LongestShots longest(max_rows);
    MediaRecord record =
        analyze(*open(), settings, [&longest](const ShotEvidence& evidence) { longest.add(evidence); });
    AnalysisSettings letter = paper_mode();
    letter.face_model = settings.face_model;
    letter.face_cascade = settings.face_cascade;
    const MediaRecord compared = analyze(*open(), letter);
    std::vector<ShotEvidence> rows = longest.shots();
    for (ShotEvidence& row : rows)
        row.letter = region_from(compared, row.shot.begin);
    Canvas sheet = drawn_sheet(title, record, rows);
    return {.record = std::move(record), .sheet = std::move(sheet)};
}

}  // namespace vitrine::analyzer
