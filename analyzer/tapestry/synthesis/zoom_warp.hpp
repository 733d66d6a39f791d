#pragma once

#include "analyzer/tapestry/synthesis/zoom_flow.hpp"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace vitrine::analyzer {

/// One level's strip on its way to the other level's: where each pixel is at any moment in between. A moment
/// is a share of the way from the coarser level to the finer one, [0, 1].
class ZoomWarp {
  public:
    /// @param flow         after fill(), of the levels `finer` - 1 and `finer` of `tapestry`
    /// @param is_to_finer  the strip is the coarser level's, which is itself at 0; else the finer one's, at 1
    ZoomWarp(const ZoomFlow& flow, const Tapestry& tapestry, std::size_t finer, bool is_to_finer);

    /// For each pixel of the strip at `share` where it is at the moment `there`.
    ///
    /// @param columns  px of the strip at `share`
    /// @return         CV_32FC2, px of the strip at `there` as cv::remap() counts them
    cv::Mat places(cv::Range columns, double share, double there) const;

    /// For each pixel of the strip at `share` how many px of the coarser strip a px of the finer one is.
    /// @return  CV_32FC1
    cv::Mat growths(cv::Range columns, double share) const;

  private:
    struct Point {
        Vec2 coarse;  // px of both strips
        Vec2 fine;
        double growth = 1;

        Vec2 at(double share) const { return coarse * (1 - share) + fine * share; }
    };

    /// A point at a moment, and what it says of it.
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

/// The flow of both levels' strips.
struct ZoomWarps {
    /// @param flow  after fill(), of the levels `finer` - 1 and `finer` of `tapestry`
    ZoomWarps(const ZoomFlow& flow, const Tapestry& tapestry, std::size_t finer)
        : coarse(flow, tapestry, finer, true), fine(flow, tapestry, finer, false) {}

    ZoomWarp coarse;
    ZoomWarp fine;
};

}  // namespace vitrine::analyzer
