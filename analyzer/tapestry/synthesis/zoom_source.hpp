#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"
#include "analyzer/tapestry/synthesis/zoom_votes.hpp"

#include <opencv2/core.hpp>

#include <cstdint>

namespace vitrine::analyzer {

/// The patches of a picture that need a match in a level.
struct WantedPatches {
    cv::Mat places;   // CV_32FC2: each pixel's place in the level by the flow
    cv::Mat is_free;  // CV_8UC1, one a patch: 0 where it needs no match
};

/// One of the two levels from which a zoom's pictures are synthesised: its patches, and the matches of a
/// picture's patches with them. The picture need not show any of them: d_complete is off.
class ZoomSource {
  public:
    /// @param picture  CV_8UC3
    explicit ZoomSource(const cv::Mat& picture);

    /// Begins the next picture: its pixels keep the matches that they had in the one before. The first
    /// picture gets the matches of the flow.
    ///
    /// @param before  CV_32FC2: the place of each pixel in the picture before
    void carry(const cv::Mat& before, const WantedPatches& wanted);

    /// Sweeps once over the matches of the picture. Each patch tries its place by the flow, too.
    void search(const PatchImage& target, const WantedPatches& wanted, int radius, std::uint32_t seed,
                const RunTasks& run);

    /// Adds the votes of the matched patches. @param share  the vote of a patch that matches exactly
    void vote(ZoomVotes& votes, double share, const RunTasks& run) const;

  private:
    Match match_near(cv::Vec2f pixel) const;

    PatchImage picture_;
    PatchRules rules_;
    MatchField matches_;  // matches of the picture's patches
};

}  // namespace vitrine::analyzer
