#pragma once

#include "analyzer/tapestry/synthesis/zoom_synthesis.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"

namespace vitrine::analyzer {

/// Two neighbouring levels in memory.
struct LevelPair {
    Tapestry index;  // index of these two levels alone, without files
    cv::Mat coarse;  // CV_8UC3, the strips
    cv::Mat fine;
};

/// The two coarsest levels of a film. @param levels  at least two
LevelPair woven_pair(const Film& film, const std::vector<Keyframes>& levels, const RetargetSettings& settings,
                     const RunTasks& run);

/// The zoom between two levels, ready to be drawn.
class StripZoom {
  public:
    /// @param pair  outlives this
    StripZoom(const LevelPair& pair, const RunTasks& run);

    const std::vector<ZoomPart>& parts() const { return parts_; }

    const ZoomWarp& coarse() const { return warps_->coarse; }

    const ZoomWarp& fine() const { return warps_->fine; }

    /// The whole strip at rules.between moments and at both ends; neighbouring parts agree.
    ZoomPictures synthesised(const ZoomRules& rules, const RunTasks& run) const;
    ZoomPictures bent(int between) const;

  private:
    void join(const ZoomPart& part, const ZoomPictures& pictures, ZoomPictures& strips) const;

    std::vector<ZoomPart> parts_;
    std::unique_ptr<ZoomWarps> warps_;
};

}  // namespace vitrine::analyzer
