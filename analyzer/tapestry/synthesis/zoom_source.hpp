#pragma once

#include "analyzer/tapestry/synthesis/patch_match.hpp"
#include "analyzer/tapestry/synthesis/zoom_votes.hpp"

#include <opencv2/core.hpp>

#include <cstdint>

namespace vitrine::analyzer {

/// The patches of a picture that need a match in a level.
struct WantedPatches {
    cv::Mat places;   // CV_32FC2, for each pixel of the picture where the flow has it in the level
    cv::Mat is_free;  // CV_8UC1, a patch: 0 where it needs no match
};

/// One of the levels that a zoom's pictures are synthesised of: its patches, and which of them a picture's
/// are matched with. Nothing of it must be in the picture: d_complete is off.
class ZoomSource {
  public:
    /// @param picture  CV_8UC3
    explicit ZoomSource(const cv::Mat& picture);

    /// The next picture: its pixels keep the matches that they had in the one before; at first they have
    /// those of the flow.
    ///
    /// @param before  CV_32FC2, for each pixel where it was in the picture before
    void carry(const cv::Mat& before, const WantedPatches& wanted);

    /// One sweep of matching the picture, in which a place of the flow is tried, too.
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
