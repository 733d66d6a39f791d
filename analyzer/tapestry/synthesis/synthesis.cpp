#include "analyzer/tapestry/synthesis/synthesis.hpp"

#include "analyzer/tapestry/synthesis/votes.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr int near_enough = 1000;  // squared grey levels of a patch: 2.6 a channel value

/// Spreads the matches of a field over a larger or smaller one.
///
/// @param growth        factor of size of the picture whose patches are matched
/// @param other_growth  factor of size of the picture in which they are matched
void spread(const MatchField& from, cv::Size2d growth, cv::Size2d other_growth, MatchField& to) {
    for (int y = 0; y < to.rows; ++y) {
        const int from_y = std::min(static_cast<int>(y / growth.height), from.rows - 1);
        for (int x = 0; x < to.columns; ++x) {
            const int from_x = std::min(static_cast<int>(x / growth.width), from.columns - 1);
            const Match& match = from.at(from_x, from_y);
            Match& spread = to.at(x, y);
            spread = {};
            const double rest_x = x - from_x * growth.width;
            const double rest_y = y - from_y * growth.height;
            spread.x = static_cast<std::int16_t>(std::max<int>(0, match.x) * other_growth.width + rest_x);
            spread.y = static_cast<std::int16_t>(std::max<int>(0, match.y) * other_growth.height + rest_y);
        }
    }
}

cv::Size2d growth(const PatchImage& from, const PatchImage& to) {
    return {static_cast<double>(to.width()) / from.width(), static_cast<double>(to.height()) / from.height()};
}

}  // namespace

Synthesis::Synthesis(const BrickWindow& window, const cv::Mat& target, KnownPart known, const RunTasks& run)
    : window_(window),
      target_(target),
      known_(std::move(known)),
      run_(run),
      matches_(window.picture, target_, window.rules) {
    fix_known();
}

void Synthesis::match_by_place() {
    MatchField& of_target = matches_.of_target();
    MatchField& of_source = matches_.of_source();
    const double down = static_cast<double>(of_source.rows) / of_target.rows;
    const int shift = window_.rules.target_x;
    for (int y = 0; y < of_target.rows; ++y)
        for (int x = 0; x < of_target.columns; ++x)
            of_target.at(x, y) = {.x = static_cast<std::int16_t>(x + shift),
                                  .y = static_cast<std::int16_t>(y * down)};
    for (int y = 0; y < of_source.rows; ++y)
        for (int x = 0; x < of_source.columns; ++x)
            of_source.at(x, y) = {.x = static_cast<std::int16_t>(x - shift),
                                  .y = static_cast<std::int16_t>(y / down)};
    matches_.refresh(run_);
}

void Synthesis::match_kept(const KeptRows& kept) {
    constexpr int half = patch_side / 2;
    const int shift = window_.rules.target_x;
    MatchField& of_target = matches_.of_target();
    for (int y = 0; y < of_target.rows; ++y)
        for (int x = 0; x < of_target.columns; ++x)
            of_target.at(x, y) = {.x = static_cast<std::int16_t>(x + shift),
                                  .y = static_cast<std::int16_t>(kept.at(x + half, y + half) - half)};
    MatchField& of_source = matches_.of_source();
    for (int x = 0; x < of_source.columns; ++x) {
        const int column = std::clamp(x + half - shift, 0, kept.columns - 1);
        int row = 0;
        for (int y = 0; y < of_source.rows; ++y) {
            while (row + 1 < kept.height && kept.at(column, row + 1) <= y + half)
                ++row;
            of_source.at(x, y) = {.x = static_cast<std::int16_t>(x - shift),
                                  .y = static_cast<std::int16_t>(row - half)};
        }
    }
    matches_.refresh(run_);
}

void Synthesis::match_like(const Synthesis& other) {
    const cv::Size2d source = growth(other.window_.picture, window_.picture);
    const cv::Size2d target = growth(other.target_, target_);
    spread(other.matches_.of_target(), target, source, matches_.of_target());
    spread(other.matches_.of_source(), source, target, matches_.of_source());
    matches_.refresh(run_);
}

double Synthesis::step(int radius, std::uint32_t seed) {
    matches_.search(radius, seed, run_, near_enough);
    matches_.share();
    const double energy = matches_.energy();
    take_votes();
    matches_.refresh(run_);
    return energy;
}

double Synthesis::energy() {
    matches_.refresh(run_);
    return matches_.energy();
}

double Synthesis::searched_energy(int radius, int rounds) {
    matches_.refresh(run_);
    for (int round = 0; round < rounds; ++round)
        matches_.search(radius, static_cast<std::uint32_t>(round), run_);
    return matches_.energy();
}

double Synthesis::exact_energy() {
    matches_.refresh(run_);
    matches_.search_everywhere();
    return matches_.energy();
}

void Synthesis::take_votes() {
    vitrine::analyzer::take_votes(matches_, window_.picture, window_.rules, target_, run_);
    fix_known();
}

void Synthesis::fix_known() {
    if (known_.picture.empty()) return;
    for (int y = 0; y < target_.height(); ++y) {
        const auto* picture = known_.picture.ptr<std::uint8_t>(y);
        const auto* share = known_.share.ptr<float>(y);
        std::uint8_t* pixel = target_.at(0, y);
        for (int x = 0; x < target_.width(); ++x, picture += 3, pixel += 4) {
            if (share[x] <= 0) continue;
            for (int c = 0; c < 3; ++c)
                pixel[c] = cv::saturate_cast<std::uint8_t>(share[x] * picture[c] + (1 - share[x]) * pixel[c]);
        }
    }
}

}  // namespace vitrine::analyzer
