#include "analyzer/tapestry/synthesis/zoom_source.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr int half_patch = patch_side / 2;
constexpr float usual_cost = 100;  // squared grey levels a channel value: such a match votes 1/e
constexpr float min_vote = 1e-6F;  // so that each free pixel has a vote

/// The first row or column of a patch, by that of its middle.
int corner(float middle, int count) {
    return std::clamp(static_cast<int>(std::lround(middle)) - half_patch, 0, count - 1);
}

}  // namespace

ZoomSource::ZoomSource(const cv::Mat& picture) : picture_(picture), rules_(free_rules(picture_)) {}

Match ZoomSource::match_near(cv::Vec2f pixel) const {
    return {.x = static_cast<std::int16_t>(corner(pixel[0], picture_.patch_columns())),
            .y = static_cast<std::int16_t>(corner(pixel[1], picture_.patch_rows()))};
}

void ZoomSource::carry(const cv::Mat& before, const WantedPatches& wanted) {
    MatchField field(wanted.is_free.cols, wanted.is_free.rows);
    for (int y = 0; y < field.rows; ++y) {
        for (int x = 0; x < field.columns; ++x) {
            const cv::Point middle(x + half_patch, y + half_patch);
            Match& match = field.at(x, y);
            if (!matches_.matches.empty()) {
                const auto& was = before.at<cv::Vec2f>(middle);
                match = matches_.at(corner(was[0], matches_.columns), corner(was[1], matches_.rows));
            }
            if (match.x < 0) match = match_near(wanted.places.at<cv::Vec2f>(middle));
        }
    }
    matches_ = std::move(field);
}

void ZoomSource::search(const PatchImage& target, const WantedPatches& wanted, int radius, std::uint32_t seed,
                        const RunTasks& run) {
    PatchMatch matches(picture_, target, rules_);
    MatchField& field = matches.of_target();
    field = std::move(matches_);
    matches.refresh(run);
    for (int y = 0; y < field.rows; ++y) {
        for (int x = 0; x < field.columns; ++x) {
            Match& match = field.at(x, y);
            if (wanted.is_free.at<std::uint8_t>(y, x) == 0) {
                match = {};
                continue;
            }
            Match other = match_near(wanted.places.at<cv::Vec2f>(y + half_patch, x + half_patch));
            other.cost = matches.cost(other.x, other.y, x, y, match.cost);
            if (other.cost < match.cost) match = other;
        }
    }
    matches.search(radius, seed, run);
    matches_ = std::move(field);
}

void ZoomSource::vote(ZoomVotes& votes, double share, const RunTasks& run) const {
    std::vector<float> weights;
    weights.reserve(matches_.matches.size());
    constexpr float scale = 1 / (usual_cost * patch_values);
    for (const Match& match : matches_.matches)
        weights.push_back(static_cast<float>(share) *
                          (std::exp(-scale * static_cast<float>(match.cost)) + min_vote));
    votes.add(matches_, picture_, weights, run);
}

}  // namespace vitrine::analyzer
