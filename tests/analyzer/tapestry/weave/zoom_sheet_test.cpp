#include "analyzer/tapestry/weave/zoom_sheet.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_levels.hpp"
#include "tests/analyzer/tapestry/weave/drawn_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace vitrine::analyzer {
namespace {

/// Strips of 600 and 1080 px.
LevelPair drawn_pair() {
    const DrawnLevels levels({240, 24});
    return {.index = levels.tapestry, .coarse = levels.coarse, .fine = levels.fine};
}

bool is_part_of(const cv::Mat& shown, const cv::Mat& strip) {
    for (int x = 0; x + shown.cols <= strip.cols; ++x)
        if (cv::norm(shown, strip.colRange(x, x + shown.cols), cv::NORM_INF) == 0) return true;
    return false;
}

}  // namespace

TEST_CASE("a zoom's strips are whole, from the one level's pixels to the other's") {
    const LevelPair pair = drawn_pair();
    const StripZoom zoom(pair, run_in_order);
    REQUIRE(zoom.parts().size() == 2);
    const ZoomPictures synthesised = zoom.synthesised({.between = 1, .rounds = 1}, run_in_order);
    for (const ZoomPictures& strips : {synthesised, zoom.bent(1)}) {
        REQUIRE(strips.size() == 3);
        CHECK(cv::norm(strips[0], pair.coarse, cv::NORM_INF) == 0);
        CHECK(strips[1].cols == 840);
        CHECK(cv::norm(strips[2], pair.fine, cv::NORM_INF) == 0);
    }
}

TEST_CASE("the sheet of a zoom shows both levels, and between them three moments in three ways") {
    const LevelPair pair = drawn_pair();
    const cv::Mat sheet = drawn_zoom(pair, run_in_order, {.between = 3, .rounds = 1});

    constexpr int height = 48;
    constexpr int step = height + 4;
    REQUIRE(sheet.size() == cv::Size(600, 10 * step + height));
    const auto row = [&](int number) { return sheet.rowRange(number * step, number * step + height); };
    CHECK(is_part_of(row(0), pair.coarse));
    CHECK(is_part_of(row(10), pair.fine));
    for (int moment = 1; moment <= 3; ++moment) {
        CHECK(cv::norm(row(moment), row(moment + 3), cv::NORM_INF) > 20);
        CHECK(cv::norm(row(moment + 3), row(moment + 6), cv::NORM_INF) > 20);
    }
}

TEST_CASE("the two coarsest levels of a film are woven in memory as they are in files") {
    const TemporaryDirectory folder;
    DrawnSource source({32, 64}, 46, false);
    const Film film = gathered(source, folder.path, nullptr);
    const RetargetSettings quick{.quality = TileQuality::on_demand};
    const WeavePlan plan{.folder = "tiles-1", .levels = {{0, 4}, {0, 2, 3, 4}, {0, 1, 2, 3, 4, 5}}};
    const Tapestry tapestry =
        PyramidWriter(folder.path, film, {.retarget = quick}, run_in_order).write({}, plan);
    const LevelPair pair = woven_pair(film, plan.levels, quick, run_in_order);

    REQUIRE(pair.index.levels.size() == 2);
    for (const std::size_t level : {0U, 1U}) {
        const cv::Mat& strip = level == 0 ? pair.coarse : pair.fine;
        CHECK(strip.size() == cv::Size(tapestry.levels[level].width, tapestry.height));
        CHECK(pair.index.levels[level].keyframes == tapestry.levels[level].keyframes);
    }
}

}  // namespace vitrine::analyzer
