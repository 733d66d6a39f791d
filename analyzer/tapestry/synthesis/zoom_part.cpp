#include "analyzer/tapestry/synthesis/zoom_part.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr int max_part_overlap = 64;  // px
constexpr double min_growth = 0.02;   // a smaller growth counts as this one

cv::Range shifted(cv::Range range, int by) {
    return {range.start + by, range.end + by};
}

}  // namespace

cv::Range ZoomPart::columns(double share) const {
    const auto between = [&](int at_coarse, int at_fine) {
        return static_cast<int>(std::lround((1 - share) * at_coarse + share * at_fine));
    };
    return {between(part.used.start, used_fine.start), between(part.used.end, used_fine.end) + overlap};
}

cv::Mat ZoomPart::places_in_coarse(const ZoomWarp& warp, double share) const {
    return warp.places(columns(share), share, 0) - cv::Scalar(part.coarse.start, 0);
}

cv::Mat ZoomPart::places_in_fine(const ZoomWarp& warp, double share) const {
    return warp.places(columns(share), share, 1) - cv::Scalar(part.fine.start, 0);
}

ZoomPart zoom_part(const Tapestry& tapestry, std::size_t finer, const ZoomFlow::Part& part,
                   const LevelStrips& strips, Islands islands) {
    const auto fine_x = [&](int x) {
        return static_cast<int>(std::lround(tapestry.x_at(finer, tapestry.time_at(finer - 1, x))));
    };
    ZoomPart made{.part = part,
                  .coarse = strips.coarse.colRange(part.coarse),
                  .fine = strips.fine.colRange(part.fine),
                  .islands = std::move(islands),
                  .used_fine = {fine_x(part.used.start), fine_x(part.used.end)}};
    if (part.used.end == strips.coarse.cols) made.used_fine.end = strips.fine.cols;
    made.overlap =
        std::min({max_part_overlap, part.coarse.end - part.used.end, part.fine.end - made.used_fine.end});
    return made;
}

ZoomPictures zoom_ends(const ZoomPart& part, int between) {
    ZoomPictures pictures(as_index(between + 2));
    pictures.front() = part.coarse.colRange(shifted(part.columns(0), -part.part.coarse.start)).clone();
    pictures.back() = part.fine.colRange(shifted(part.columns(1), -part.part.fine.start)).clone();
    return pictures;
}

ZoomPictures bent_zoom(const ZoomPart& part, const ZoomWarps& warps, int between) {
    ZoomPictures pictures = zoom_ends(part, between);
    for (int i = 1; i <= between; ++i) {
        const double share = static_cast<double>(i) / (between + 1);
        const cv::Mat growths = cv::max(warps.fine.growths(part.columns(share), share), min_growth);
        const cv::Mat coverage = share / ((1 - share) * growths + share);
        pictures[as_index(i)] = over(bent(part.coarse, part.places_in_coarse(warps.coarse, share)),
                                     bent(part.fine, part.places_in_fine(warps.fine, share)), coverage);
    }
    return pictures;
}

cv::Mat bent(const cv::Mat& picture, const cv::Mat& places) {
    cv::Mat bent;
    cv::remap(picture, bent, places, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    return bent;
}

cv::Mat over(const cv::Mat& below, const cv::Mat& above, const cv::Mat& share) {
    cv::Mat mixed(below.size(), CV_8UC3);
    for (int y = 0; y < below.rows; ++y) {
        for (int x = 0; x < below.cols; ++x) {
            const float part = share.at<float>(y, x);
            const cv::Vec3b& low = below.at<cv::Vec3b>(y, x);
            const cv::Vec3b& high = above.at<cv::Vec3b>(y, x);
            for (int c = 0; c < 3; ++c)
                mixed.at<cv::Vec3b>(y, x)[c] =
                    cv::saturate_cast<std::uint8_t>((1 - part) * low[c] + part * high[c]);
        }
    }
    return mixed;
}

}  // namespace vitrine::analyzer
