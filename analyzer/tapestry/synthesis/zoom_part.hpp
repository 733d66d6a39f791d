#pragma once

#include "analyzer/tapestry/synthesis/zoom_warp.hpp"

#include <opencv2/core.hpp>

#include <vector>

namespace vitrine::analyzer {

/// Two neighbouring levels as a whole: CV_8UC3.
struct LevelStrips {
    cv::Mat coarse;
    cv::Mat fine;
};

/// A part of two neighbouring levels, px for px.
struct ZoomPart {
    ZoomFlow::Part part;
    cv::Mat coarse;       // CV_8UC3, columns part.coarse of the coarser strip
    cv::Mat fine;         // CV_8UC3, columns part.fine of the finer one
    Islands islands;      // as ZoomFlow::match() has found them
    cv::Range used_fine;  // what is used of the finer strip: the same times as part.used
    int overlap = 0;      // px beyond what is used, with which the part to the right begins

    /// The columns of the strip that its picture shows at a moment, px: from one level's place to the other's
    /// evenly.
    cv::Range columns(double share) const;

    /// For each pixel of those columns where `coarse` or `fine` has it, CV_32FC2.
    cv::Mat places_in_coarse(const ZoomWarp& warp, double share) const;
    cv::Mat places_in_fine(const ZoomWarp& warp, double share) const;
};

ZoomPart zoom_part(const Tapestry& tapestry, std::size_t finer, const ZoomFlow::Part& part,
                   const LevelStrips& strips, Islands islands);

/// A part of the strip on its way from level to level: CV_8UC3, the coarser level first, the finer one last.
using ZoomPictures = std::vector<cv::Mat>;

/// The levels' own pixels first and last, and room for so many pictures between them.
ZoomPictures zoom_ends(const ZoomPart& part, int between);

/// A zoom as a graphics card has it: both levels bent, the finer one drawn over the coarser one.
ZoomPictures bent_zoom(const ZoomPart& part, const ZoomWarps& warps, int between);

/// @param places  CV_32FC2, for each pixel where it comes from
cv::Mat bent(const cv::Mat& picture, const cv::Mat& places);

/// Both pictures, CV_8UC3, the second one with its share. @param share  CV_32FC1 in [0, 1]
cv::Mat over(const cv::Mat& below, const cv::Mat& above, const cv::Mat& share);

}  // namespace vitrine::analyzer
