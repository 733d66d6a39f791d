// Neighbouring pixels at the seams of bricks and tiles differ no more than anywhere else in the strip.

#include "analyzer/tapestry/synthesis/weave.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_keyframes.hpp"

#include <doctest/doctest.h>

namespace vitrine::analyzer {
namespace {

const Brickwork wall{.keyframes = 11, .brick = {150, 40}};

std::vector<Keyframe> bricks_of_the_wall() {
    return drawn_keyframes(wall);
}

cv::Mat woven(const std::vector<Keyframe>& bricks) {
    std::vector<cv::Mat> parts;
    weave_level({wall, [&](int k) { return bricks[static_cast<std::size_t>(k)]; }},
                [&](const cv::Mat& columns, const WovenSoFar&) { parts.push_back(columns.clone()); },
                {.quality = TileQuality::on_demand});
    cv::Mat strip;
    cv::hconcat(parts, strip);
    return strip;
}

/// The bricks side by side, as tall as the tapestry.
cv::Mat squeezed(const std::vector<Keyframe>& bricks) {
    cv::Mat strip = brick_window({wall, bricks}, {0, wall.width()}, 1).picture.bgr();
    cv::resize(strip, strip, {wall.width(), tapestry_height(wall)}, 0, 0, cv::INTER_AREA);
    return strip;
}

/// The mean squared step from column x - 1 to x, in some rows.
double step_at(const cv::Mat& strip, int x, cv::Range rows) {
    const cv::Rect here(x, rows.start, 1, rows.size());
    const double norm = cv::norm(strip(here), strip(here - cv::Point(1, 0)), cv::NORM_L2);
    return norm * norm / (3 * rows.size());
}

double step_inside(const cv::Mat& strip) {
    double sum = 0;
    for (int x = 1; x < strip.cols; ++x)
        sum += step_at(strip, x, {0, strip.rows});
    return sum / (strip.cols - 1);
}

double step_at_bricks(const cv::Mat& strip) {
    double sum = 0;
    for (int k = 2; k < wall.bricks(); ++k) {
        const int top = k % 2 * strip.rows / 2;
        sum += step_at(strip, wall.place(k).x, {top, top + strip.rows / 2});
    }
    return sum / (wall.bricks() - 2);
}

double step_at_tiles(const cv::Mat& strip) {
    double sum = 0;
    int count = 0;
    const std::vector<TileSpan> spans = tile_spans(strip.cols, wall.brick.height);
    const int overlap = tile_overlap(wall.brick.height);
    REQUIRE(spans.size() > 1);
    for (std::size_t i = 1; i < spans.size(); ++i) {
        for (const int x : {0, overlap / 2, overlap}) {
            sum += step_at(strip, spans[i].from + x, {0, strip.rows});
            ++count;
        }
    }
    return sum / count;
}

// Limits for the steps at seams over the mean step of all columns. Bricks side by side have steps 50 times as
// large.
constexpr double brick_margin = 2;
constexpr double tile_margin = 1.2;

}  // namespace

TEST_CASE("steps between pixels are no higher where bricks or tiles met than inside") {
    const std::vector<Keyframe> bricks = bricks_of_the_wall();
    const cv::Mat strip = woven(bricks);
    const double inside = step_inside(strip);

    CHECK(step_at_bricks(squeezed(bricks)) > 10 * inside);
    CHECK(step_at_bricks(strip) <= brick_margin * inside);
    CHECK(step_at_tiles(strip) <= tile_margin * inside);
}

}  // namespace vitrine::analyzer
