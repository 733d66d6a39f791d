#include "analyzer/tapestry/synthesis/carve_input.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_keyframes.hpp"

#include <doctest/doctest.h>

namespace vitrine::analyzer {
namespace {

CarveInput input_of(const cv::Mat& picture) {
    return {.picture = picture,
            .bricks = cv::Mat(picture.size(), CV_16SC1, cv::Scalar(0)),
            .loss = cv::Mat(picture.size(), CV_32FC1, cv::Scalar(0)),
            .given = {}};
}

}  // namespace

TEST_CASE("carving takes plain rows and leaves what stands on them whole") {
    cv::Mat picture(40, 60, CV_8UC3, cv::Scalar(90, 60, 30));
    cv::circle(picture, {30, 20}, 8, cv::Scalar(20, 200, 250), cv::FILLED);
    const KeptRows kept = carved(input_of(picture), 30);
    const cv::Mat left = picture_of(picture, kept);

    CHECK(left.size() == cv::Size(60, 30));
    const auto coloured = [](const cv::Mat& shown) {
        cv::Mat found;
        cv::inRange(shown, cv::Scalar(20, 200, 250), cv::Scalar(20, 200, 250), found);
        return cv::countNonZero(found);
    };
    CHECK(coloured(left) == coloured(picture));
}

TEST_CASE("rows that are left stay in order, and break off only where the brick changes") {
    const cv::Mat picture = drawn_keyframe({50, 40}, 4).picture;
    CarveInput input = input_of(picture);
    input.bricks.colRange(25, 50).setTo(1);
    input.loss.colRange(0, 25).rowRange(10, 40).setTo(1e6);
    input.loss.colRange(25, 50).rowRange(0, 30).setTo(1e6);
    const KeptRows kept = carved(input, 30);
    for (int x = 0; x < 50; ++x) {
        CAPTURE(x);
        for (int y = 1; y < 30; ++y)
            CHECK(kept.at(x, y) > kept.at(x, y - 1));
        CHECK(kept.at(x, 0) == (x < 25 ? 10 : 0));
        CHECK(kept.at(x, 29) == (x < 25 ? 39 : 29));
    }
}

TEST_CASE("a tile is carved as the columns that its neighbour made of the same bricks") {
    const cv::Mat picture = drawn_keyframe({60, 48}, 9).picture;
    const KeptRows neighbour = carved(input_of(picture), 36);
    const cv::Mat known = picture_of(picture, neighbour);
    cv::Mat columns(1, 60, CV_8UC1, cv::Scalar(0));
    columns.colRange(0, 16).setTo(1);
    CarveInput input = input_of(picture);
    give_rows(input, known, columns);
    const cv::Mat again = picture_of(picture, carved(input, 36));

    // Rows of the sky are a few grey levels apart, shapes far more.
    CHECK(cv::norm(again.colRange(0, 16), known.colRange(0, 16), cv::NORM_INF) <= 6);
    CHECK(cv::countNonZero(input.given.colRange(16, 60)) == 0);
}

}  // namespace vitrine::analyzer
