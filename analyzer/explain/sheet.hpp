#pragma once

#include "analyzer/explain/canvas.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "base/state/record.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Keeps the evidence of the longest shots of a file, in time order, so that a long film needs little memory.
class LongestShots {
  public:
    explicit LongestShots(std::size_t most) : most_(most) {}

    void add(ShotEvidence evidence);

    const std::vector<ShotEvidence>& shots() const { return shots_; }

  private:
    std::size_t most_;
    std::vector<ShotEvidence> shots_;
};

/// A file as its sheet names it.
struct SheetTitle {
    std::string name;         // any bytes
    std::uint64_t bytes = 0;  // 0: not said
};

/// The sheet that explains what the analysis saw in one file, the paper's figure 4.4 for any medium: a time
/// line of all shots, then a row for each of `rows` with its first, middle and last sample, the region as it
/// lies then, the way it still goes, the faces and, where known, the region by the paper's letter; S_M, S_I,
/// S_F and S of the middle one, and the accumulated volume.
///
/// @param record  of the whole file; `rows` are some of its shots
Canvas drawn_sheet(const SheetTitle& title, const MediaRecord& record, const std::vector<ShotEvidence>& rows);

}  // namespace vitrine::analyzer
