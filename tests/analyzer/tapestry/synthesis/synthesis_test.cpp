#include "analyzer/tapestry/synthesis/synthesis.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "tests/analyzer/tapestry/synthesis/drawn_keyframes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace vitrine::analyzer {
namespace {

const RunTasks in_order = run_in_order;

int letter_distance(const cv::Mat& a, cv::Point at_a, const cv::Mat& b, cv::Point at_b) {
    int sum = 0;
    for (int y = 0; y < patch_side; ++y) {
        for (int x = 0; x < patch_side; ++x) {
            const auto p = a.at<cv::Vec3b>(at_a.y + y, at_a.x + x);
            const auto q = b.at<cv::Vec3b>(at_b.y + y, at_b.x + x);
            for (int c = 0; c < 3; ++c)
                sum += (p[c] - q[c]) * (p[c] - q[c]);
        }
    }
    return sum;
}

/// Eq. 1 with the distance of eq. 2, to the letter, for a window at full size.
double letter_energy(const Brickwork& brickwork, const std::vector<Keyframe>& bricks, const cv::Mat& target,
                     const WindowSettings& settings) {
    struct Patch {
        int brick;
        cv::Point at;
        double weight;
        double nearest = std::numeric_limits<double>::infinity();
    };

    std::vector<Patch> source;
    for (int k = 0; k < brickwork.bricks(); ++k) {
        for (int y = 0; y + patch_side <= brickwork.brick.height; ++y) {
            for (int x = 0; x + patch_side <= brickwork.brick.width; ++x) {
                const auto touches = [&](const cv::Rect& face) {
                    return !(face & cv::Rect(x, y, patch_side, patch_side)).empty();
                };
                const bool is_face = std::ranges::any_of(bricks[static_cast<std::size_t>(k)].faces, touches);
                source.push_back({.brick = k, .at = {x, y}, .weight = is_face ? settings.face_weight : 1.0});
            }
        }
    }
    double coherent = 0;
    constexpr int half_patch = patch_side / 2;
    const double half = brickwork.brick.width / 2.0;
    for (int y = 0; y + patch_side <= target.rows; ++y) {
        for (int x = 0; x + patch_side <= target.cols; ++x) {
            double nearest = std::numeric_limits<double>::infinity();
            for (Patch& patch : source) {
                const double middle = brickwork.place(patch.brick).x + half;
                const double beyond = std::max(0.0, std::abs(middle - x - half_patch) - half) / half;
                const double cost = letter_distance(bricks[static_cast<std::size_t>(patch.brick)].picture,
                                                    patch.at, target, {x, y}) +
                                    std::floor(settings.time_cost * patch_values * beyond * beyond);
                nearest = std::min(nearest, cost);
                patch.nearest = std::min(patch.nearest, cost);
            }
            coherent += nearest;
        }
    }
    double complete = 0;
    double weights = 0;
    for (const Patch& patch : source) {
        complete += patch.weight * patch.nearest;
        weights += patch.weight;
    }
    const double patches = (target.rows - patch_side + 1) * (target.cols - patch_side + 1);
    return (complete / weights + coherent / patches) / patch_values;
}

}  // namespace

TEST_CASE("two patches are as far apart as their pixels say") {
    const cv::Mat a = drawn_keyframe({40, 30}, 1).picture;
    const cv::Mat b = drawn_keyframe({33, 21}, 2).picture;
    const PatchImage image_a(a);
    const PatchImage image_b(b);
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
        const cv::Point at_a(static_cast<int>(random() % 34), static_cast<int>(random() % 24));
        const cv::Point at_b(static_cast<int>(random() % 27), static_cast<int>(random() % 15));
        CHECK(patch_distance()(image_a.at(at_a.x, at_a.y), image_a.stride(), image_b.at(at_b.x, at_b.y),
                               image_b.stride(),
                               std::numeric_limits<int>::max()) == letter_distance(a, at_a, b, at_b));
    }
    CHECK(patch_distance()(image_a.at(0, 0), image_a.stride(), image_b.at(0, 0), image_b.stride(), 10) > 10);
}

TEST_CASE("the energy is that of equations 1 and 2, to the letter") {
    const Brickwork brickwork{.keyframes = 3, .brick = {16, 12}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    bricks[1].faces = {{4, 3, 5, 5}};
    const WindowSettings settings;
    const BrickWindow window = brick_window({brickwork, bricks}, {0, brickwork.width()}, 1, settings);
    cv::Mat squeezed;
    cv::resize(window.picture.bgr(), squeezed, {brickwork.width(), 18}, 0, 0, cv::INTER_AREA);
    Synthesis synthesis(window, squeezed, {}, in_order);
    synthesis.match_by_place();
    const double energy = synthesis.exact_energy();

    CHECK(energy == doctest::Approx(letter_energy(brickwork, bricks, squeezed, settings)).epsilon(1e-6));
}

TEST_CASE("no round makes the energy rise, and the search comes near the best matches") {
    const Brickwork brickwork{.keyframes = 4, .brick = {26, 20}};
    const std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    const BrickWindow window = brick_window({brickwork, bricks}, {0, brickwork.width()}, 1);
    cv::Mat squeezed;
    cv::resize(window.picture.bgr(), squeezed, {brickwork.width(), 30}, 0, 0, cv::INTER_AREA);
    Synthesis synthesis(window, squeezed, {}, in_order);
    synthesis.match_by_place();
    double before = synthesis.energy();
    const double first = before;
    for (unsigned round = 1; round <= 15; ++round) {
        CAPTURE(round);
        const double searched = synthesis.step(16, round);
        CHECK(searched <= before * (1 + 1e-6));
        const double voted = synthesis.energy();
        CHECK(voted <= searched * (1 + 1e-6));
        before = voted;
    }
    CHECK(before < 0.6 * first);
    CHECK(before <= 1.15 * synthesis.exact_energy());
}

TEST_CASE("patches that cross from one keyframe to another are not used") {
    const Brickwork brickwork{.keyframes = 2, .brick = {20, 14}};
    std::vector<Keyframe> bricks = drawn_keyframes(brickwork);
    const BrickWindow window = brick_window({brickwork, bricks}, {0, brickwork.width()}, 1);
    const int columns = window.picture.patch_columns();
    for (int y = 0; y < window.picture.patch_rows(); ++y) {
        for (int x = 0; x < columns; ++x) {
            const cv::Rect patch(x, y, patch_side, patch_side);
            int expected = PatchRules::no_brick;
            for (int k = 0; k < 2; ++k)
                if ((brickwork.place(k) & patch) == patch) expected = k;
            CHECK(window.rules.owners[as_index(y * columns + x)] == expected);
        }
    }
}

}  // namespace vitrine::analyzer
