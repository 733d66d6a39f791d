#include "analyzer/tapestry/synthesis/retarget.hpp"

#include "analyzer/tapestry/synthesis/weave.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_keyframes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

namespace vitrine::analyzer {
namespace {

bool are_equal(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

cv::Mat made(const Brickwork& brickwork, const std::vector<Keyframe>& bricks,
             const TileNeighbours& neighbours = {}, const RunTasks& run = run_in_order,
             TileQuality quality = TileQuality::on_demand) {
    return retarget_tile({brickwork, bricks}, {0, brickwork.width()}, neighbours, {.quality = quality}, run);
}

}  // namespace

TEST_CASE("a tile is three quarters as tall, and of the keyframes' colours") {
    const Brickwork brickwork{.keyframes = 4, .brick = {40, 30}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    for (Keyframe& keyframe : bricks)
        keyframe.picture.setTo(cv::Scalar(10, 120, 200));
    const cv::Mat tile = made(brickwork, bricks);

    CHECK(tile.size() == cv::Size(100, 45));
    CHECK(cv::norm(tile, cv::Mat(tile.size(), CV_8UC3, cv::Scalar(10, 120, 200)), cv::NORM_INF) == 0);
}

TEST_CASE("pictures that do not go together fade into one another at the border of their bricks") {
    const Brickwork brickwork{.keyframes = 4, .brick = {120, 90}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    for (std::size_t k = 0; k < bricks.size(); ++k)
        bricks[k].picture.setTo(cv::Scalar::all(k < 2 ? 40 : 220));
    const cv::Mat tile = made(brickwork, bricks);
    int largest = 0;
    for (int x = 100; x < 140; ++x)
        for (int y = 10; y < 50; ++y)
            largest =
                std::max(largest, std::abs(tile.at<cv::Vec3b>(y, x)[0] - tile.at<cv::Vec3b>(y, x - 1)[0]));
    CHECK(largest < 60);
    CHECK(std::abs(tile.at<cv::Vec3b>(30, 60)[0] - 40) <= 2);
    CHECK(std::abs(tile.at<cv::Vec3b>(30, 180)[0] - 220) <= 2);
}

TEST_CASE("detailed pictures that do not go together are stitched at the border of their bricks") {
    const Brickwork brickwork{.keyframes = 4, .brick = {200, 150}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    for (std::size_t k = 0; k < bricks.size(); ++k)
        bricks[k].picture = bricks[k].picture / 4 + cv::Scalar::all(k < 2 ? 10 : 180);
    const cv::Mat row = made(brickwork, bricks).rowRange(10, 50);
    const auto largest_step = [&](int from, int to) {
        double largest = 0;
        for (int x = from; x < to; ++x) {
            cv::Mat difference;
            cv::absdiff(row.col(x), row.col(x - 1), difference);
            largest = std::max(largest, cv::mean(difference)[0]);
        }
        return largest;
    };
    CHECK(largest_step(180, 220) < 2.8 * largest_step(120, 180));  // 3.3 times without stitches
    CHECK(cv::mean(row.colRange(20, 180))[0] < 90);
    CHECK(cv::mean(row.colRange(220, 380))[0] > 170);
}

TEST_CASE("a tile does not depend on the threads that make it") {
    const Brickwork brickwork{.keyframes = 3, .brick = {60, 44}};
    const std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    const RunTasks backwards_on_threads = [](int count, const std::function<void(int)>& task) {
        std::vector<std::jthread> threads;
        for (int i = count; i-- > 0;)
            threads.emplace_back(task, i);
    };
    CHECK(are_equal(made(brickwork, bricks), made(brickwork, bricks, {}, backwards_on_threads)));
}

TEST_CASE("what a neighbour knows of a tile stays as it is at the border") {
    const Brickwork brickwork{.keyframes = 4, .brick = {40, 30}};
    const std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    TileNeighbours neighbours;
    neighbours.left = drawn_keyframe({20, 45}, 77).picture;
    neighbours.right = drawn_keyframe({20, 45}, 78).picture;
    const cv::Mat tile = made(brickwork, bricks, neighbours);

    CHECK(are_equal(tile.colRange(0, 10), neighbours.left.colRange(0, 10)));
    CHECK(are_equal(tile.colRange(90, 100), neighbours.right.colRange(10, 20)));
    CHECK_FALSE(are_equal(tile.colRange(15, 20), neighbours.left.colRange(15, 20)));
}

TEST_CASE("what matters in a keyframe weighs more than the rest, as a face does") {
    const Brickwork brickwork{.keyframes = 4, .brick = {40, 30}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    bricks[0].region = {{10, 5}, {30, 5}, {30, 25}, {10, 25}};
    const WindowSettings settings{.face_weight = 9, .region_weight = 3};
    const BrickWindow window = brick_window({brickwork, bricks}, {0, brickwork.width()}, 1, settings);
    const int columns = window.picture.patch_columns();
    const auto weight = [&](int x, int y) {
        return window.rules
            .weights[static_cast<std::size_t>((y - patch_side / 2) * columns + x - patch_side / 2)];
    };
    CHECK(weight(20, 15) == 3);
    CHECK(weight(12, 7) == 3);
    CHECK(weight(6, 15) == 1);
    CHECK(weight(60, 15) == 1);
}

TEST_CASE(
    "beside the first brick of the lower row stands its margin, mirrored and sharp where nothing matters") {
    const Brickwork brickwork{.keyframes = 4, .brick = {40, 32}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    for (int x = 0; x < 40; ++x)
        bricks[1].picture.col(x).setTo(cv::Scalar::all(x / 4 % 2 * 200));
    const auto sharpness = [&](const std::vector<cv::Point>& region) {
        bricks[1].region = region;
        const cv::Mat bricks_drawn =
            brick_window({brickwork, bricks}, {0, brickwork.width()}, 1).picture.bgr();
        const cv::Mat half = bricks_drawn(cv::Rect(0, 32, 20, 32));
        cv::Mat mirrored;
        cv::flip(bricks[1].picture.colRange(0, 20), mirrored, 1);
        if (region.front().x >= 20) CHECK(are_equal(half, mirrored));
        cv::Scalar mean;
        cv::Scalar deviation;
        cv::meanStdDev(half, mean, deviation);
        return deviation[0];
    };
    CHECK(sharpness({{20, 4}, {36, 4}, {36, 28}, {20, 28}}) > 90);
    CHECK(sharpness({{2, 4}, {36, 4}, {36, 28}, {2, 28}}) < 60);  // its figure would be cut in halves
}

TEST_CASE("a single keyframe stands alone, as tall as the tapestry") {
    const Brickwork brickwork{.keyframes = 1, .brick = {160, 90}};
    cv::Mat picture(90, 160, CV_8UC3, cv::Scalar(200, 30, 30));
    picture.colRange(80, 160).setTo(cv::Scalar(30, 30, 200));
    cv::Mat strip;
    weave_level({brickwork, [&](int) { return Keyframe{.picture = picture, .faces = {}}; }},
                [&](const cv::Mat& columns, const WovenSoFar&) { strip = columns.clone(); });
    REQUIRE(strip.size() == cv::Size(240, 135));
    CHECK(cv::norm(strip.colRange(0, 110), cv::Mat(135, 110, CV_8UC3, cv::Scalar(200, 30, 30)),
                   cv::NORM_INF) == 0);
    CHECK(cv::norm(strip.colRange(130, 240), cv::Mat(135, 110, CV_8UC3, cv::Scalar(30, 30, 200)),
                   cv::NORM_INF) == 0);
}

TEST_CASE("tiles cover a strip, each begins in the one before") {
    for (const int width : {89, 500, 700, 2225, 10'000, 1'000'000}) {
        CAPTURE(width);
        const std::vector<TileSpan> spans = tile_spans(width, 100);
        CHECK(spans.front().from == 0);
        CHECK(spans.back().to == width);
        for (std::size_t i = 1; i < spans.size(); ++i) {
            CHECK(spans[i].from == spans[i - 1].to - tile_overlap(100));
            CHECK(spans[i].to - spans[i].from <= 700);
            CHECK(spans[i].to - spans[i].from >= 300);
        }
    }
}

TEST_CASE("tiles of tall bricks are as wide, measured by bricks, and reach as far into one another") {
    const std::vector<TileSpan> small = tile_spans(10'000, 200);
    for (const int growth : {2, 4, 10}) {
        CAPTURE(growth);
        const std::vector<TileSpan> spans = tile_spans(10'000 * growth, 200 * growth);
        CHECK(spans.size() == small.size());
        CHECK(spans[0].to - spans[1].from == growth * (small[0].to - small[1].from));
    }
}

TEST_CASE("a level is woven to its end, of one keyframe too") {
    for (const int keyframes : {1, 2, 9}) {
        CAPTURE(keyframes);
        const Brickwork brickwork{.keyframes = keyframes, .brick = {160, 20}};
        int columns = 0;
        weave_level(
            {brickwork, [&](int k) { return drawn_keyframe(brickwork.brick, static_cast<unsigned>(k)); }},
            [&](const cv::Mat& part, const WovenSoFar&) {
                CHECK(part.rows == 30);
                columns += part.cols;
            },
            {.quality = TileQuality::on_demand});
        CHECK(columns == brickwork.width());
    }
}

TEST_CASE("a level that was cut off goes on with the same columns") {
    const Brickwork brickwork{.keyframes = 9, .brick = {200, 20}};
    const auto keyframe = [&](int k) { return drawn_keyframe(brickwork.brick, static_cast<unsigned>(k)); };
    const RetargetSettings quick{.quality = TileQuality::on_demand};
    std::vector<cv::Mat> parts;
    std::vector<WovenSoFar> places;
    weave_level(
        {brickwork, keyframe},
        [&](const cv::Mat& part, const WovenSoFar& done) {
            parts.push_back(part.clone());
            places.push_back(done);
        },
        quick);
    REQUIRE(parts.size() == 2);
    REQUIRE(places[0].tiles == 1);
    std::vector<cv::Mat> rest;
    weave_level(
        {brickwork, keyframe}, [&](const cv::Mat& part, const WovenSoFar&) { rest.push_back(part.clone()); },
        quick, run_in_order, places[0]);
    REQUIRE(rest.size() == 1);
    CHECK(cv::norm(rest[0], parts[1], cv::NORM_INF) == 0);
}

}  // namespace vitrine::analyzer
