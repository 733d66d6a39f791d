#include "analyzer/tapestry/synthesis/zoom_flow.hpp"

#include "tests/analyzer/tapestry/synthesis/drawn_levels.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace vitrine::analyzer {
namespace {

/// The drawn levels with the flow between them.
struct Levels : DrawnLevels {
    ZoomFlow flow() const {
        ZoomFlow flow(tapestry, 1);
        for (const ZoomFlow::Part& part : flow.parts())
            flow.match(part, coarse.colRange(part.coarse), fine.colRange(part.fine));
        flow.fill();
        return flow;
    }

    /// The field's value at the point nearest to a place of the strip.
    struct Known {
        Vec2 point;
        Vec2 place;
        double growth;
    };

    Known at(const ZoomFlow& flow, double x, double y, bool is_to_finer) const {
        const int tile = static_cast<int>(x) / tapestry.tile_width;
        const ZoomField field = flow.field(tile, is_to_finer);
        const int column = static_cast<int>(std::lround((x - tile * tapestry.tile_width) / ZoomField::step));
        const int row = static_cast<int>(std::lround(y * (ZoomField::rows - 1) / tapestry.height));
        return {field.point(column, row) + Vec2{1.0 * tile * tapestry.tile_width, 0},
                field.place(column, row), field.growths[field.number(column, row)]};
    }
};

}  // namespace

TEST_CASE("what both levels show keeps its shape and moves from the one place to the other") {
    const Levels levels;
    const ZoomFlow flow = levels.flow();

    CHECK(flow.matched() > 0.5);
    for (std::size_t k = 0; k < levels.kept.size(); ++k) {
        const double way = (levels.kept[k] - static_cast<double>(k)) * levels.brick.width / 2.0;
        const double middle = levels.tapestry.middle(0, k);
        const double y = levels.brick.height * (k % 2 == 0 ? 0.5 : 1.5);
        const auto there = levels.at(flow, middle, y, true);
        CHECK(there.place.x - there.point.x == doctest::Approx(way).epsilon(0.01));
        CHECK(std::abs(there.place.y - there.point.y) < 1);
        CHECK(there.growth == doctest::Approx(1).epsilon(0.1));
        const auto back = levels.at(flow, middle + way, y, false);
        CHECK(back.place.x - back.point.x == doctest::Approx(-way).epsilon(0.01));
        CHECK(back.growth == doctest::Approx(1).epsilon(0.1));
    }
}

TEST_CASE("what only the finer level shows comes out of next to nothing") {
    const Levels levels;
    const ZoomFlow flow = levels.flow();
    for (const int k : {1, 2, 5, 6}) {
        const auto from =
            levels.at(flow, levels.tapestry.middle(1, static_cast<std::size_t>(k)), 25 + k % 2 * 50, false);
        CHECK(from.growth < 0.4);
    }
}

TEST_CASE("a zoom's ends are the strips' ends, and no point is farther off than a brick") {
    const Levels levels;
    const ZoomFlow flow = levels.flow();
    const Tapestry& tapestry = levels.tapestry;
    for (const bool is_to_finer : {true, false}) {
        const std::size_t own = is_to_finer ? 0 : 1;
        const std::size_t other = 1 - own;
        for (int tile = 0; tile < tapestry.tiles(own); ++tile) {
            const ZoomField field = zoom_field_from_bytes(to_bytes(flow.field(tile, is_to_finer)));
            const double left = tile * tapestry.tile_width;
            for (int row = 0; row < ZoomField::rows; ++row) {
                for (int column = 0; column < field.columns(); ++column) {
                    const double here = left + field.point(column, row).x;
                    const double there = field.place(column, row).x;
                    if (here == 0) CHECK(there == 0);
                    if (here == tapestry.levels[own].width) CHECK(there == tapestry.levels[other].width);
                    const double coarse = is_to_finer ? here : there;
                    const double fine = is_to_finer ? there : here;
                    const double expected = tapestry.x_at(0, tapestry.time_at(1, fine));
                    CHECK(std::abs(coarse - expected) <= levels.brick.width + 0.2);
                }
            }
        }
    }
}

TEST_CASE("tiles beside each other agree on the edge that they share") {
    const Levels levels;
    const ZoomFlow flow = levels.flow();
    for (int tile = 0; tile + 1 < levels.tapestry.tiles(1); ++tile) {
        const ZoomField left = flow.field(tile, false);
        const ZoomField right = flow.field(tile + 1, false);
        for (int row = 0; row < ZoomField::rows; ++row) {
            CHECK(left.place(left.columns() - 1, row) == right.place(0, row));
            CHECK(left.growths[left.number(left.columns() - 1, row)] == right.growths[right.number(0, row)]);
        }
    }
}

TEST_CASE("pictures that have nothing in common have no islands") {
    cv::Mat coarse(100, 200, CV_8UC3);
    cv::Mat fine(100, 300, CV_8UC3);
    cv::theRNG().state = 5;
    cv::randu(coarse, 0, 256);
    cv::randu(fine, 0, 256);
    const auto same = [](cv::Point at) { return at; };
    const Islands islands = find_islands(coarse, fine, {same, same}, {.min_area = 200});
    CHECK(cv::countNonZero(islands.number) == 0);
}

}  // namespace vitrine::analyzer
