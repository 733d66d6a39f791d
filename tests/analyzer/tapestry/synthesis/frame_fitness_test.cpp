#include "analyzer/tapestry/synthesis/frame_fitness.hpp"

#include "analyzer/tapestry/synthesis/keyframes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace vitrine::analyzer {
namespace {

using Pixels = decltype(FrameSignature::pixels);
using namespace std::chrono_literals;

/// Smooth blotches that differ from seed to seed: one scene each.
Pixels scene(int seed) {
    Pixels pixels{};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto x = static_cast<double>(i / 3 % FrameSignature::width);
        const auto y = static_cast<double>(i / 3 / FrameSignature::width);
        pixels[i] = static_cast<std::uint8_t>(128 + 60 * std::sin(seed * 1.7 + x * (0.2 + 0.1 * seed)) +
                                              50 * std::cos(seed * 2.3 + y * (0.3 + 0.07 * seed)));
    }
    return pixels;
}

Pixels mixed(const Pixels& a, const Pixels& b, double share) {
    Pixels pixels{};
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(std::lround((1 - share) * a[i] + share * b[i]));
    return pixels;
}

/// Frames at 2 a second.
std::vector<FrameSignature> film_of(std::initializer_list<Pixels> pictures) {
    std::vector<FrameSignature> frames;
    for (const Pixels& pixels : pictures)
        frames.push_back({.time = 500ms * static_cast<int>(frames.size()), .pixels = pixels});
    return frames;
}

Pixels plain(int grey) {
    Pixels pixels{};
    pixels.fill(static_cast<std::uint8_t>(grey));
    return pixels;
}

int alike_pairs(const std::vector<FrameSignature>& frames, const Keyframes& keyframes) {
    int alike = 0;
    for (std::size_t k = 1; k < keyframes.size(); ++k)
        alike += difference(frames[static_cast<std::size_t>(keyframes[k - 1])],
                            frames[static_cast<std::size_t>(keyframes[k])]) < 20
                     ? 1
                     : 0;
    return alike;
}

std::vector<Keyframes> levels_of(const std::vector<FrameSignature>& frames,
                                 const std::vector<FilmPart>& shots = {}) {
    return keyframe_levels(affinity(frames), {.rules = KeyframeRules{.frames = frames,
                                                                     .fit = fit_frames(frames, shots),
                                                                     .takes = takes_of(frames, shots)}});
}

}  // namespace

TEST_CASE("black, plain and white frames are not fit; where nothing else is, the richest frame is") {
    const auto frames = film_of({plain(0), scene(1), plain(255), plain(90)});
    CHECK(fit_frames(frames, {}) == std::vector<bool>{false, true, false, false});
    CHECK(fit_frames(film_of({plain(0), plain(3)}), {}) == std::vector<bool>{true, false});
}

TEST_CASE("a flash is not fit, a short shot of another brightness is") {
    const Pixels lit = mixed(scene(1), plain(255), 0.6);
    const auto flash = film_of({scene(1), scene(1), lit, scene(1), scene(1)});
    const std::vector<FilmPart> shot{{0ms, 2500ms}};
    CHECK(fit_frames(flash, shot) == std::vector<bool>{true, true, false, true, true});
    const auto cut = film_of({scene(1), scene(1), lit, scene(2), scene(2)});
    CHECK(fit_frames(cut, shot)[2]);
}

TEST_CASE("frames of fades and dissolves are not fit, the same frames within a shot are") {
    const auto frames = film_of({scene(1), scene(1), mixed(scene(1), scene(4), 0.5), scene(4), scene(4),
                                 mixed(scene(4), plain(0), 0.5), plain(0)});
    CHECK(fit_frames(frames, {}) == std::vector<bool>{true, true, false, true, true, false, false});
    const std::vector<FilmPart> shots{{0ms, 3000ms}};
    CHECK(fit_frames(frames, shots) == std::vector<bool>{true, true, true, true, true, true, false});
}

TEST_CASE("a lit scene between two fades is fit") {
    const auto frames = film_of({plain(0), mixed(plain(0), scene(3), 0.4), scene(3), scene(3),
                                 mixed(plain(0), scene(3), 0.5), plain(0)});
    CHECK(fit_frames(frames, {}) == std::vector<bool>{false, false, true, true, false, false});
}

TEST_CASE("shots of a second or more are takes") {
    const auto frames = film_of({scene(1), scene(1), scene(2), scene(3), scene(3)});
    const std::vector<FilmPart> shots{{0ms, 1000ms}, {1000ms, 1500ms}, {1500ms, 2500ms}};
    CHECK(takes_of(frames, shots) == std::vector<int>{0, 0, -1, 2, 2});
    CHECK(takes_of(frames, {}) == std::vector<int>{-1, -1, -1, -1, -1});
}

TEST_CASE("a film has as many keyframes as it has pictures to tell, none twice") {
    std::vector<FrameSignature> frames;
    std::vector<FilmPart> shots;
    for (int shot = 0; shot < 6; ++shot) {
        shots.push_back({frames.size() * 500ms, (frames.size() + 8) * 500ms});
        for (int i = 0; i < 8; ++i)
            frames.push_back({.time = 500ms * static_cast<int>(frames.size()), .pixels = scene(shot)});
    }
    const auto levels = levels_of(frames, shots);
    REQUIRE(levels.size() == 1);
    REQUIRE(levels[0].size() == 6);
    for (int shot = 0; shot < 6; ++shot)
        CHECK(levels[0][static_cast<std::size_t>(shot)] / 8 == shot);
}

TEST_CASE("a take that looks like the one before has its keyframe") {
    std::vector<FrameSignature> frames;
    for (int i = 0; i < 24; ++i)
        frames.push_back({.time = 500ms * i, .pixels = mixed(scene(i / 8), scene(1), i < 16 ? 0.9 : 0)});
    const std::vector<FilmPart> shots{{0ms, 4s}, {4s, 8s}, {8s, 12s}};
    CHECK(levels_of(frames, shots)[0].size() == 3);
    CHECK(levels_of(frames)[0].size() == 2);
}

TEST_CASE("a still has one keyframe; a picture that changes slowly has finer levels") {
    std::vector<FrameSignature> still;
    std::vector<FrameSignature> slow;
    for (int i = 0; i < 40; ++i) {
        still.push_back({.time = 500ms * i, .pixels = scene(2)});
        slow.push_back({.time = 500ms * i, .pixels = mixed(scene(2), scene(5), i / 40.0)});
    }
    CHECK(levels_of(still) == std::vector<Keyframes>{{levels_of(still)[0][0]}});
    const std::vector<FilmPart> shot{{0s, 20s}};
    const auto levels = levels_of(slow, shot);
    REQUIRE(levels.size() >= 2);
    CHECK(levels[0].size() >= 4);
    CHECK(alike_pairs(slow, levels[0]) <= static_cast<int>(levels[0].size()) / 2);
    for (std::size_t i = 1; i < levels.size(); ++i) {
        CHECK(std::ranges::includes(levels[i], levels[i - 1]));
        CHECK(levels[i].size() <= 2 * levels[i - 1].size());
    }
}

TEST_CASE("a long film of many scenes has 24 keyframes first, then twice as many, up to all scenes") {
    std::vector<FrameSignature> frames;
    std::vector<FilmPart> shots;
    for (int shot = 0; shot < 120; ++shot) {
        shots.push_back({frames.size() * 500ms, (frames.size() + 2) * 500ms});
        for (int i = 0; i < 2; ++i)
            frames.push_back({.time = 500ms * static_cast<int>(frames.size()), .pixels = scene(shot % 11)});
    }
    const auto levels = levels_of(frames, shots);
    REQUIRE(levels.size() >= 3);
    CHECK(levels[0].size() == 24);
    CHECK(levels[1].size() == 48);
    CHECK(levels[2].size() == 96);
    for (const Keyframes& level : levels)
        CHECK(level.size() <= 120);
}

}  // namespace vitrine::analyzer
