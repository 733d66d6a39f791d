#include "analyzer/saliency/take_parts.hpp"

#include <doctest/doctest.h>
#include <opencv2/core.hpp>

#include <functional>
#include <vector>

using namespace vitrine::analyzer;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

/// Samples five times a second; something moves at the left, or at the right, or nothing.
std::vector<Sample> take(int count, const std::function<char(double)>& side) {
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        const char moves = side(i / 5.0);
        Sample sample{.time = milliseconds(200) * i, .image = SaliencyMap::zeros(90, 160, CV_32FC1)};
        if (moves != 0) sample.image(cv::Rect(moves == 'l' ? 10 : 110, 30, 40, 40)).setTo(1);
        sample.changed_share = moves == 0 ? 0 : .05;
        samples.push_back(sample);
    }
    return samples;
}

}  // namespace

TEST_CASE("a take of ten seconds and one in which nothing ever moves are not split") {
    const auto still = [](double) { return char{0}; };
    CHECK(take_parts(take(50, [](double t) { return t > 5 ? 'l' : char{0}; }), {}, seconds(10)) ==
          std::vector{TakePart{{}, seconds(10)}});
    CHECK(take_parts(take(150, still), {}, seconds(30)) == std::vector{TakePart{{}, seconds(30)}});
}

TEST_CASE("seconds of a long take in which nothing moves are empty") {
    const auto side = [](double t) { return (t > 4 && t < 8) || (t > 15 && t < 18) ? 'l' : char{0}; };
    const auto parts = take_parts(take(150, side), {}, seconds(30));
    REQUIRE(parts.size() == 5);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        CHECK(parts[i].is_empty == (i % 2 == 0));
        CHECK(parts[i].begin == (i == 0 ? std::chrono::nanoseconds(0) : parts[i - 1].end));
    }
    CHECK(parts[1].begin < milliseconds(4000));
    CHECK(parts[1].end > milliseconds(8000));
    CHECK(parts[1].end - parts[1].begin < milliseconds(6500));
    CHECK(parts[4].end == seconds(30));
}

TEST_CASE("a long take is split where what matters changes its place") {
    const auto parts = take_parts(take(75, [](double t) { return t < 7 ? 'l' : 'r'; }), {}, seconds(15));
    REQUIRE(parts.size() == 2);
    CHECK(std::chrono::abs(parts[0].end - seconds(7)) <= milliseconds(400));
    CHECK(take_parts(take(75, [](double) { return 'l'; }), {}, seconds(15)).size() == 1);
}
