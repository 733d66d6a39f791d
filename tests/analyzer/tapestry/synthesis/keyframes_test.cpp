#include "analyzer/tapestry/synthesis/keyframes.hpp"

#include "analyzer/tapestry/synthesis/medoids.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

namespace vitrine::analyzer {
namespace {

Affinity random_costs(int frames, int band, unsigned seed) {
    std::mt19937 random(seed);
    Affinity costs(frames, band);
    float most = 0;
    for (int j = 0; j < frames; ++j) {
        for (int i = costs.first(j); i < costs.last(j); ++i) {
            const int shot = static_cast<int>(seed % 4 + 3);
            const float away = i / shot == j / shot ? 5.F : 60.F;
            const auto cost = static_cast<float>(random() % 40) + away + static_cast<float>(std::abs(i - j));
            costs.set(i, j, i == j ? 0 : cost);
            most = std::max(most, cost);
        }
    }
    costs.set_far(2 * most);
    return costs;
}

double cost_of(const Affinity& costs, const Keyframes& keyframes) {
    double sum = 0;
    for (int i = 0; i < costs.frames(); ++i) {
        float least = costs.far();
        for (const int j : keyframes)
            least = std::min(least, costs.at(i, j));
        sum += least;
    }
    return sum;
}

bool keeps_rows(const Keyframes& coarse, const Keyframes& fine) {
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        const auto found = std::ranges::lower_bound(fine, coarse[k]);
        if (found == fine.end() || *found != coarse[k]) return false;
        if (static_cast<std::size_t>(found - fine.begin()) % 2 != k % 2) return false;
    }
    return true;
}

/// The best of all sets of `count` frames that hold `coarse`, each in its row.
double brute_force(const Affinity& costs, int count, const Keyframes& coarse = {}) {
    double best = std::numeric_limits<double>::infinity();
    for (unsigned set = 0; set < 1U << costs.frames(); ++set) {
        if (std::popcount(set) != count) continue;
        Keyframes keyframes;
        for (int i = 0; i < costs.frames(); ++i)
            if ((set >> i & 1U) != 0) keyframes.push_back(i);
        if (keeps_rows(coarse, keyframes)) best = std::min(best, cost_of(costs, keyframes));
    }
    return best;
}

bool is_subset(const Keyframes& coarse, const Keyframes& fine) {
    return std::ranges::includes(fine, coarse);
}

std::vector<FrameSignature> frames_at_2_fps(int count, int shots) {
    std::vector<FrameSignature> frames;
    for (int i = 0; i < count; ++i) {
        frames.push_back({.time = std::chrono::milliseconds(500 * i)});
        frames.back().pixels.fill(static_cast<std::uint8_t>(i * shots / count * 60));
    }
    return frames;
}

}  // namespace

TEST_CASE("the first level is as good as the best of all sets, or nearly") {
    int exact = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Affinity costs = random_costs(12, 11, seed);
        const auto levels = keyframe_levels(costs, {.first = 3, .max_levels = 1});
        const double best = brute_force(costs, 3);
        const double got = cost_of(costs, levels[0]);
        CAPTURE(seed);
        CHECK(got <= 1.05 * best);
        exact += got <= best * (1 + 1e-9) ? 1 : 0;
    }
    CHECK(exact >= 10);
}

TEST_CASE("the second level is as good as the best that keeps the first and its rows, or nearly") {
    int exact = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Affinity costs = random_costs(12, 8, seed);
        const auto levels = keyframe_levels(costs, {.first = 3, .max_levels = 2});
        REQUIRE(levels.size() == 2);
        const double best = brute_force(costs, 6, levels[0]);
        const double got = cost_of(costs, levels[1]);
        CAPTURE(seed);
        CHECK(got <= 1.05 * best);
        exact += got <= best * (1 + 1e-9) ? 1 : 0;
    }
    CHECK(exact >= 10);
}

TEST_CASE("each level holds the one before, twice as many, each keyframe in its row") {
    const Affinity costs = random_costs(400, 60, 3);
    const auto levels = keyframe_levels(costs);

    REQUIRE(levels.size() >= 5);
    CHECK(levels[0].size() == 24);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        CAPTURE(i);
        CHECK(is_subset(levels[i - 1], levels[i]));
        CHECK(keeps_rows(levels[i - 1], levels[i]));
        CHECK(std::ranges::is_sorted(levels[i]));
        if (i < 4) CHECK(levels[i].size() == 2 * levels[i - 1].size());
        CHECK(cost_of(costs, levels[i]) < cost_of(costs, levels[i - 1]));
    }
}

TEST_CASE("without rows every frame is a keyframe in the end") {
    const Affinity costs = random_costs(101, 30, 5);
    const auto levels = keyframe_levels(costs, {.keeps_rows = false});

    CHECK(levels.back().size() == 101);
    for (std::size_t i = 1; i < levels.size(); ++i)
        CHECK(is_subset(levels[i - 1], levels[i]));
}

TEST_CASE("the cost kept by steps is the cost computed anew") {
    const Affinity costs = random_costs(60, 20, 7);
    Medoids medoids(costs);
    std::mt19937 random(1);
    std::vector<double> changes;
    for (int frame = 3; frame < 60; frame += 11)
        medoids.add(frame);
    for (int step = 0; step < 200; ++step) {
        const int in = static_cast<int>(random() % 60);
        if (medoids.contains(in)) continue;
        const double before = medoids.cost();
        CHECK(before == doctest::Approx(cost_of(costs, medoids.sorted())));
        const int out = medoids.sorted()[random() % medoids.sorted().size()];
        medoids.swap_changes(in, 0, 60, changes);
        medoids.swap(out, in);
        CHECK(medoids.cost() - before == doctest::Approx(changes[static_cast<std::size_t>(out)]));
    }
}

TEST_CASE("films that are one shot, black, two seconds long or empty of time have their levels") {
    for (const int count : {1, 2, 3, 4, 23, 25, 40}) {
        for (const int shots : {1, 2}) {
            CAPTURE(count);
            CAPTURE(shots);
            const auto frames = frames_at_2_fps(count, shots);
            const Affinity costs = affinity(frames);
            const auto levels = keyframe_levels(costs);
            CHECK(levels[0].size() == static_cast<std::size_t>(std::min(24, count)));
            CHECK(levels.back().size() + 25 > static_cast<std::size_t>(count));
        }
    }
}

TEST_CASE("one shot gets keyframes all over its time") {
    const auto frames = frames_at_2_fps(80, 1);
    const auto levels = keyframe_levels(affinity(frames), {.first = 8});

    int before = -1;
    for (const int frame : levels[0]) {
        CHECK(frame - before <= 20);
        before = frame;
    }
    CHECK(80 - before <= 20);
}

TEST_CASE("uniform keyframes lie in the middle of equal parts") {
    CHECK(uniform_keyframes(10, 5) == Keyframes{1, 3, 5, 7, 9});
    CHECK(uniform_keyframes(3, 24) == Keyframes{0, 1, 2});
    const auto frames = frames_at_2_fps(480, 1);
    const auto levels = refined_levels(time_affinity(frames), uniform_keyframes(480, 24));
    for (std::size_t i = 1; i < levels.size(); ++i)
        CHECK(keeps_rows(levels[i - 1], levels[i]));
}

TEST_CASE("keyframes chosen by hand are the frames nearest to their times") {
    using std::chrono::milliseconds;
    const auto frames = frames_at_2_fps(10, 1);
    const std::vector<std::chrono::nanoseconds> times{milliseconds(3900), milliseconds(0), milliseconds(260),
                                                      milliseconds(500), milliseconds(99'000)};
    CHECK(keyframes_at(frames, times) == Keyframes{0, 1, 8, 9});
}

}  // namespace vitrine::analyzer
