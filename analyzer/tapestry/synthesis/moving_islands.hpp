#pragma once

#include "analyzer/tapestry/synthesis/zoom_part.hpp"

#include <opencv2/core.hpp>

namespace vitrine::analyzer {

/// The pixels of a picture that are known before anything is synthesised.
struct KnownPixels {
    cv::Mat picture;  // CV_8UC3
    cv::Mat share;    // CV_32FC1 in [0, 1]: how far a pixel is known; 1: wholly
};

/// The islands of a part between the coarser level and the finer one. Each island moves at a constant speed.
/// It takes its surroundings along as far as it has grown at that moment.
class MovingIslands {
  public:
    /// @param part, warps  outlive this
    MovingIslands(const ZoomPart& part, const ZoomWarps& warps);

    /// The known pixels at a moment: a mix of both levels on islands, the coarser level's pixels around them.
    /// At 0 all pixels are known.
    /// @param share  the moment: a share of the way from the coarser level to the finer one
    KnownPixels at(double share) const;

  private:
    cv::Mat sea(const cv::Mat& flow) const;
    cv::Mat grown(double share) const;
    void carry(cv::Mat& places, cv::Mat& share, double moment) const;

    const ZoomPart& part_;
    const ZoomWarps& warps_;
    cv::Mat distance_;  // CV_32FC1: each pixel's distance from the nearest island, px of the coarser part
    cv::Mat ways_;      // CV_32FC2: way of each pixel's nearest island pixel to the finer level, px
};

}  // namespace vitrine::analyzer
