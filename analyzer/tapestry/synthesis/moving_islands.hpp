#pragma once

#include "analyzer/tapestry/synthesis/zoom_part.hpp"

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The pixels of a picture that are known before anything is synthesised.
struct KnownPixels {
    cv::Mat picture;  // CV_8UC3
    cv::Mat share;    // CV_32FC1 in [0, 1]: how much of it; 1: all
};

/// A part's islands on their way from the coarser level to the finer one: each goes at a constant speed, and
/// what is around it goes with it as far as it has grown by then.
class MovingIslands {
  public:
    /// @param part, warps  outlive this
    MovingIslands(const ZoomPart& part, const ZoomWarps& warps);

    /// Both levels' pixels on islands, the coarser one's around them. At 0 they are all there is.
    /// @param share  the moment
    KnownPixels at(double share) const;

  private:
    cv::Mat sea(const cv::Mat& flow) const;
    cv::Mat grown(double share) const;
    void carry(cv::Mat& places, cv::Mat& share, double moment) const;

    const ZoomPart& part_;
    const ZoomWarps& warps_;
    cv::Mat distance_;  // CV_32FC1, px of the coarser part's pixels from an island
    cv::Mat ways_;      // CV_32FC2, px that the island's pixel nearest to each goes to the finer level
};

}  // namespace vitrine::analyzer
