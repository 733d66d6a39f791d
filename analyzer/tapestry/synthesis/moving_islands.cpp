#include "analyzer/tapestry/synthesis/moving_islands.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/patch_image.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr double max_miss = 2;  // px by which an island's pixel may miss the flow
constexpr float soft_edge = 8;  // px around an island in which it fades
constexpr double growing = 4;   // islands grow by (1 - moment)^growing of the part's height

cv::Mat nearest_of(const cv::Mat& numbers, const cv::Mat& places) {
    cv::Mat found;
    cv::remap(numbers, found, places, cv::noArray(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    return found;
}

/// Gives each pixel the way of the land pixel nearest to it.
///
/// @param sea      CV_8UC1, 0: land, of which there is some
/// @param nearest  CV_32SC1, the numbers that cv::distanceTransform() has given to land
cv::Mat with_land(const cv::Mat& sea, const cv::Mat& nearest, const cv::Mat& ways) {
    std::vector<cv::Vec2f> of_land(sea.total() + 1);
    for (int y = 0; y < sea.rows; ++y)
        for (int x = 0; x < sea.cols; ++x)
            if (sea.at<std::uint8_t>(y, x) == 0)
                of_land[as_index(nearest.at<int>(y, x))] = ways.at<cv::Vec2f>(y, x);
    cv::Mat all(sea.size(), CV_32FC2);
    for (int y = 0; y < sea.rows; ++y)
        for (int x = 0; x < sea.cols; ++x)
            all.at<cv::Vec2f>(y, x) = of_land[as_index(nearest.at<int>(y, x))];
    return all;
}

/// Each pixel's own place, `begin` columns further right.
cv::Mat own_places(cv::Size size, int begin) {
    cv::Mat places(size, CV_32FC2);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            places.at<cv::Vec2f>(y, x) = {static_cast<float>(x + begin), static_cast<float>(y)};
    return places;
}

}  // namespace

MovingIslands::MovingIslands(const ZoomPart& part, const ZoomWarps& warps) : part_(part), warps_(warps) {
    const cv::Mat flow = warps.coarse.places(part.part.coarse, 0, 1);
    const cv::Mat sea_of = sea(flow);
    cv::Mat nearest;
    cv::distanceTransform(sea_of, distance_, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    distance_ = cv::min(distance_, static_cast<double>(sea_of.rows));
    ways_ = flow - own_places(flow.size(), part.part.coarse.start);
    if (cv::countNonZero(sea_of) < static_cast<int>(sea_of.total()))
        ways_ = with_land(sea_of, nearest, ways_);
}

/// The mask of the coarser level: 0 where an island holds a pixel and the flow moves it likewise, else 1.
cv::Mat MovingIslands::sea(const cv::Mat& flow) const {
    cv::Mat sea(part_.coarse.size(), CV_8UC1, cv::Scalar::all(1));
    for (int y = 0; y < sea.rows; ++y) {
        for (int x = 0; x < sea.cols; ++x) {
            if (part_.islands.number.at<int>(y, x) == 0) continue;
            const cv::Vec2i place = part_.islands.place.at<cv::Vec2i>(y, x);
            const cv::Vec2d there = flow.at<cv::Vec2f>(y, x);
            if (std::abs(place[0] + part_.part.fine.start - there[0]) <= max_miss &&
                std::abs(place[1] - there[1]) <= max_miss)
                sea.at<std::uint8_t>(y, x) = 0;
        }
    }
    cv::erode(sea, sea, cv::Mat::ones(patch_side, patch_side, CV_8UC1));  // islands consist of whole patches
    return sea;
}

/// The islands as far as they have grown at a moment, with soft edges: [0, 1] for each pixel of the coarser
/// part.
cv::Mat MovingIslands::grown(double share) const {
    const double reach = std::pow(1 - share, growing) * part_.coarse.rows;
    const cv::Mat grown = 1 - (distance_ - reach) / soft_edge;
    return cv::max(0.0, cv::min(1.0, grown));
}

/// Moves each pixel of a moment with the nearest island, as far as the pixel belongs to it.
/// @param places  places in the coarser level by the flow; replaced by those of the islands
/// @param share   set to the share of the island in each pixel, [0, 1]
void MovingIslands::carry(cv::Mat& places, cv::Mat& share, double moment) const {
    const cv::Mat ways = nearest_of(ways_, places);
    places = own_places(places.size(), part_.columns(moment).start - part_.part.coarse.start) - ways * moment;
    share = bent(grown(moment), places);
    const cv::Mat ways_there = nearest_of(ways_, places);
    for (int y = 0; y < share.rows; ++y) {
        for (int x = 0; x < share.cols; ++x) {
            const cv::Vec2f miss = ways_there.at<cv::Vec2f>(y, x) - ways.at<cv::Vec2f>(y, x);
            const double px = moment * std::max(std::abs(miss[0]), std::abs(miss[1]));
            share.at<float>(y, x) *= static_cast<float>(std::clamp(2 - px / max_miss, 0.0, 1.0));
        }
    }
    cv::Mat soft;
    cv::blur(share, soft, {patch_side, patch_side}, {-1, -1}, cv::BORDER_REPLICATE);
    share = cv::min(share, soft);
}

KnownPixels MovingIslands::at(double share) const {
    KnownPixels known;
    cv::Mat places = part_.places_in_coarse(warps_.coarse, share);
    carry(places, known.share, share);
    const cv::Mat of_both = bent(grown(1), places) * share;
    known.picture =
        over(bent(part_.coarse, places), bent(part_.fine, part_.places_in_fine(warps_.fine, share)), of_both);
    return known;
}

}  // namespace vitrine::analyzer
