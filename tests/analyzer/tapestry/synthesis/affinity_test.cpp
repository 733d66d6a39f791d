#include "analyzer/tapestry/synthesis/affinity.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/patch_scan.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace vitrine::analyzer {
namespace {

using std::chrono::milliseconds;

constexpr int side = 7;

/// A picture of smooth patches and some noise, the same for the same seed.
FrameSignature drawn(unsigned seed, milliseconds time = {}) {
    std::mt19937 random(seed);
    FrameSignature frame{.time = time};
    const unsigned period = 3 + seed % 5;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        const std::size_t x = i / 3 % FrameSignature::width;
        frame.pixels[i] =
            static_cast<std::uint8_t>((x * period * 9 + seed * 37 + i % 3 * 50 + random() % 30) % 256);
    }
    return frame;
}

int patch_distance(const FrameSignature& a, int ax, int ay, const FrameSignature& b, int bx, int by) {
    int sum = 0;
    for (int y = 0; y < side; ++y) {
        for (int i = 0; i < 3 * side; ++i) {
            const auto at = [&](const FrameSignature& f, int fx, int fy) {
                return int{f.pixels[as_index(3 * ((fy + y) * FrameSignature::width + fx) + i)]};
            };
            const int difference = std::min(127, std::abs(at(a, ax, ay) - at(b, bx, by)));
            sum += difference * difference;
        }
    }
    return sum;
}

/// Eq. 3 without time, to the letter.
double letter(const FrameSignature& a, const FrameSignature& b) {
    constexpr int columns = FrameSignature::width - side + 1;
    constexpr int rows = FrameSignature::height - side + 1;
    double sum = 0;
    for (int i = 0; i < columns * rows; ++i) {
        int nearest = std::numeric_limits<int>::max();
        for (int j = 0; j < columns * rows; ++j)
            nearest =
                std::min(nearest, patch_distance(a, i % columns, i / columns, b, j % columns, j / columns));
        sum += nearest;
    }
    return sum / (columns * rows) / (3 * side * side);
}

}  // namespace

TEST_CASE("the distances of sixteen pairs at once are those of equation 3") {
    std::vector<FrameSignature> frames;
    for (unsigned seed = 1; seed <= 3; ++seed)
        frames.push_back(drawn(seed));
    const ScanResult result = scan_patches(frames[0], frame_block(frames));

    CHECK(result.by_block[0] == 0);
    CHECK(result.of_block[0] == 0);
    for (std::size_t j = 1; j < frames.size(); ++j) {
        CAPTURE(j);
        const double by = letter(frames[0], frames[j]);
        const double of = letter(frames[j], frames[0]);
        CHECK(std::abs(result.by_block[j] - by) < 1.5 + 0.02 * by);  // 16-bit sums
        CHECK(std::abs(result.of_block[j] - of) < 1.5 + 0.02 * of);
    }
}

TEST_CASE("a frame that shows a part of another costs more to show than it costs to be shown") {
    FrameSignature plain{};
    plain.pixels.fill(90);
    FrameSignature with_bar = plain;
    for (std::size_t y = 0; y < FrameSignature::height; ++y)
        for (std::size_t i = 0; i < std::size_t{3} * 6; ++i)
            with_bar.pixels[3 * (y * FrameSignature::width + 13) + i] = 200;
    const std::vector<FrameSignature> frames{plain, with_bar};
    const Affinity costs = affinity(frames);

    CHECK(costs.at(0, 1) == 0);  // every patch of the plain one is found beside the bar
    CHECK(costs.at(1, 0) > 500);
}

TEST_CASE("time costs as much as a usual pair at its scale, and pairs far apart are not compared") {
    std::vector<FrameSignature> frames;
    for (int i = 0; i < 40; ++i) {
        frames.push_back({.time = std::chrono::seconds(10 * i)});
        frames.back().pixels.fill(i % 2 == 0 ? 0 : 60);
    }
    const Affinity costs = affinity(frames);

    CHECK(costs.band() == 24);
    const float usual = costs.at(0, 1) / (1 + 1.F / 36);
    CHECK(usual == doctest::Approx(3600).epsilon(0.02));
    CHECK(costs.at(0, 6) == doctest::Approx(usual).epsilon(0.01));
    CHECK(costs.at(6, 0) == doctest::Approx(usual).epsilon(0.01));
    CHECK(costs.at(0, 30) == costs.far());
    CHECK(costs.far() > costs.at(0, 23));
}

TEST_CASE("the affinity does not depend on the order in which its rows are computed") {
    std::vector<FrameSignature> frames;
    frames.reserve(21);
    for (unsigned i = 0; i < 21; ++i)
        frames.push_back(drawn(i, milliseconds(500 * i)));
    const Affinity forward = affinity(frames);
    const Affinity backward = affinity(frames, {}, [](int count, const std::function<void(int)>& task) {
        for (int i = count; i-- > 0;)
            task(i);
    });

    for (int i = 0; i < 21; ++i)
        for (int j = 0; j < 21; ++j)
            CHECK(forward.at(i, j) == backward.at(i, j));
}

}  // namespace vitrine::analyzer
