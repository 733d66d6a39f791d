#pragma once

#include "analyzer/explain/canvas.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "base/state/record.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The evidence of the longest shots of a file, in time order: a long film needs little memory.
class LongestShots {
  public:
    explicit LongestShots(std::size_t max_shots) : max_shots_(max_shots) {}

    void add(ShotEvidence evidence);

    const std::vector<ShotEvidence>& shots() const { return shots_; }

  private:
    std::size_t max_shots_;
    std::vector<ShotEvidence> shots_;
};

/// The heading of a sheet.
struct SheetTitle {
    std::string name;         // any bytes
    std::uint64_t bytes = 0;  // 0: not said
};

/// Draws the sheet that explains the analysis of one file, the paper's figure 4.4 for any medium: a time line
/// of all shots, then a row for each of `rows` with its first, middle and last sample. Each sample shows the
/// region at its time, the way that the region still goes, the faces, the lines of text and, where known, the
/// region by the paper's letter. Beside the samples are S_M, S_I, S_F and S of the middle one, and the
/// accumulated volume.
///
/// @param record  the whole file; `rows` are some of its shots
Canvas drawn_sheet(const SheetTitle& title, const MediaRecord& record, const std::vector<ShotEvidence>& rows);

}  // namespace vitrine::analyzer
