#include "analyzer/tapestry/weave/poster.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::analyzer {

namespace {

constexpr int rounding = 3;  // px by which bricks of an even height may make a strip too tall

cv::Mat as_tall_as(const cv::Mat& strip, int height) {
    const int rest = strip.rows - height;
    if (rest >= 0 && rest <= rounding) return strip.rowRange(rest / 2, rest / 2 + height);
    const double scale = static_cast<double>(height) / strip.rows;
    cv::Mat poster;
    cv::resize(strip, poster, {static_cast<int>(std::lround(strip.cols * scale)), height}, 0, 0,
               scale > 1 ? cv::INTER_CUBIC : cv::INTER_AREA);
    return poster;
}

}  // namespace

SharpFrames poster_frames(const Candidates& kept, int height, std::size_t keyframes) {
    const double brick = keyframes == 1 ? height : height / (2 * kept_height);
    return frames_as_tall_as(kept, static_cast<int>(std::ceil(brick / 2)) * 2);
}

Poster drawn_poster(const Film& film, const Keyframes& keyframes, int height, const RunTasks& run) {
    const cv::Mat strip = keyframes.size() == 1 ? film.candidates->keyframe(keyframes[0]).picture
                                                : woven_strip(film, keyframes, {}, run);
    return {.picture = as_tall_as(strip, height),
            .enlargement = std::max(1.0, static_cast<double>(height) / strip.rows)};
}

}  // namespace vitrine::analyzer
