#pragma once

#include "analyzer/tapestry/synthesis/zoom_flow.hpp"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace vitrine::analyzer {

/// Bends one level's strip towards the other level's: gives the place of each pixel at any moment in between.
/// A moment is a share of the way from the coarser level to the finer one, [0, 1].
class ZoomWarp {
  public:
    /// @param flow         the flow between the levels `finer` - 1 and `finer` of `tapestry`, after fill()
    /// @param is_to_finer  true: the strip of the coarser level, unbent at 0; else of the finer one, unbent
    ///                     at 1
    ZoomWarp(const ZoomFlow& flow, const Tapestry& tapestry, std::size_t finer, bool is_to_finer);

    /// The place at the moment `there` of each pixel of the strip at the moment `share`.
    ///
    /// @param columns  px of the strip at `share`
    /// @return         CV_32FC2, px of the strip at `there` as cv::remap() counts them
    cv::Mat places(cv::Range columns, double share, double there) const;

    /// The width of a px of the finer strip in px of the coarser one, for each pixel of the strip at `share`.
    /// @return  CV_32FC1
    cv::Mat growths(cv::Range columns, double share) const;

  private:
    struct Point {
        Vec2 coarse;  // place in the coarser strip, px
        Vec2 fine;    // place in the finer strip, px
        double growth = 1;

        Vec2 at(double share) const { return coarse * (1 - share) + fine * share; }
    };

    /// A point at a moment, with the value to draw there.
    struct Corner {
        Vec2 place;
        Vec2 value;
    };

    template <typename ValueOf> cv::Mat drawn(cv::Range columns, double share, const ValueOf& value_of) const;
    static void draw(const std::array<Corner, 3>& corners, int from, cv::Mat& picture);

    int columns_ = 0;
    int height_ = 0;             // px of the strips
    std::vector<Point> points_;  // ZoomField::rows rows of columns_
};

/// The warps of both levels' strips.
struct ZoomWarps {
    /// @param flow  the flow between the levels `finer` - 1 and `finer` of `tapestry`, after fill()
    ZoomWarps(const ZoomFlow& flow, const Tapestry& tapestry, std::size_t finer)
        : coarse(flow, tapestry, finer, true), fine(flow, tapestry, finer, false) {}

    ZoomWarp coarse;
    ZoomWarp fine;
};

}  // namespace vitrine::analyzer
