#pragma once

#include "analyzer/tapestry/synthesis/zoom_warp.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

/// The whole strips of two neighbouring levels: CV_8UC3.
struct LevelStrips {
    cv::Mat coarse;
    cv::Mat fine;
};

/// A part of two neighbouring levels with its pixels.
struct ZoomPart {
    ZoomFlow::Part part;
    cv::Mat coarse;       // CV_8UC3, columns part.coarse of the coarser strip
    cv::Mat fine;         // CV_8UC3, columns part.fine of the finer one
    Islands islands;      // found by ZoomFlow::match()
    cv::Range used_fine;  // used columns of the finer strip: the same times as part.used
    int overlap = 0;      // px beyond the used columns; the part to the right begins with them

    /// The columns of the strip that the part's picture shows at a moment, px. They move evenly from one
    /// level's place to the other's.
    cv::Range columns(double share) const;

    /// The place of each pixel of those columns in `coarse` or `fine`, CV_32FC2.
    cv::Mat places_in_coarse(const ZoomWarp& warp, double share) const;
    cv::Mat places_in_fine(const ZoomWarp& warp, double share) const;
};

ZoomPart zoom_part(const Tapestry& tapestry, std::size_t finer, const ZoomFlow::Part& part,
                   const LevelStrips& strips, Islands islands);

/// The pictures of a part from level to level: CV_8UC3, the coarser level first, the finer one last.
using ZoomPictures = std::vector<cv::Mat>;

/// A zoom with the levels' own pixels first and last, and `between` empty pictures between them.
ZoomPictures zoom_ends(const ZoomPart& part, int between);

/// Draws the zoom as a graphics card does: both levels bent along the flow, the finer one over the coarser
/// one.
ZoomPictures bent_zoom(const ZoomPart& part, const ZoomWarps& warps, int between);

/// Bends a picture along a flow. @param places  CV_32FC2: the place from which each pixel comes
cv::Mat bent(const cv::Mat& picture, const cv::Mat& places);

/// Draws one picture, CV_8UC3, over another. @param share  CV_32FC1 in [0, 1]: the share of `above`
cv::Mat over(const cv::Mat& below, const cv::Mat& above, const cv::Mat& share);

}  // namespace vitrine::analyzer
