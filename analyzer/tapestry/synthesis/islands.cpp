#include "analyzer/tapestry/synthesis/islands.hpp"

#include "analyzer/tapestry/synthesis/as_index.hpp"
#include "analyzer/tapestry/synthesis/patch_match.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr int sweeps = 5;
constexpr int half_patch = patch_side / 2;  // px from a patch's corner to the pixel that it stands for

Match match_at(cv::Point corner, const MatchField& in) {
    return {.x = static_cast<std::int16_t>(std::clamp(corner.x, 0, in.columns - 1)),
            .y = static_cast<std::int16_t>(std::clamp(corner.y, 0, in.rows - 1))};
}

void begin_with(MatchField& field, const MatchField& other, const PlaceGuess& guess) {
    const cv::Point half(half_patch, half_patch);
    for (int y = 0; y < field.rows; ++y)
        for (int x = 0; x < field.columns; ++x)
            field.at(x, y) = match_at(guess(cv::Point(x, y) + half) - half, other);
}

/// The rules by which all patches of the finer picture may be used and should be found.
PatchRules rules_for(const PatchImage& fine) {
    const std::size_t patches = as_index(fine.patch_columns()) * as_index(fine.patch_rows());
    PatchRules rules;
    rules.owners.assign(patches, 0);
    rules.weights.assign(patches, 1);
    rules.centres = {0};
    return rules;
}

/// Joins patches to islands, one island after another.
class Joining {
  public:
    Joining(const PatchMatch& matches, const IslandRules& rules) : matches_(matches), rules_(rules) {
        const MatchField& field = matches.of_target();
        numbers_ = cv::Mat(field.rows, field.columns, CV_32SC1, cv::Scalar::all(0));
        for (int y = 0; y < field.rows; ++y)
            for (int x = 0; x < field.columns; ++x)
                if (numbers_.at<int>(y, x) == 0 && is_sure({x, y})) join({x, y});
    }

    const cv::Mat& numbers() const { return numbers_; }

  private:
    bool is_sure(cv::Point at) const {
        const Match& there = matches_.of_target().at(at.x, at.y);
        const Match& back = matches_.of_source().at(there.x, there.y);
        return std::abs(back.x - at.x) <= rules_.max_way_back &&
               std::abs(back.y - at.y) <= rules_.max_way_back && there.cost <= rules_.max_cost * patch_values;
    }

    cv::Point way(cv::Point at) const {
        const Match& there = matches_.of_target().at(at.x, at.y);
        return {there.x - at.x, there.y - at.y};
    }

    void join(cv::Point first) {
        const int number = next_;
        std::vector<cv::Point> joined{first};
        numbers_.at<int>(first) = number;
        for (std::size_t i = 0; i < joined.size(); ++i) {
            const cv::Point at = joined[i];
            for (const cv::Point step : std::array<cv::Point, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
                const cv::Point beside = at + step;
                if (beside.x < 0 || beside.y < 0 || beside.x >= numbers_.cols || beside.y >= numbers_.rows ||
                    numbers_.at<int>(beside) != 0 || !is_sure(beside))
                    continue;
                const cv::Point bend = way(beside) - way(at);
                if (std::abs(bend.x) > rules_.max_bend || std::abs(bend.y) > rules_.max_bend) continue;
                numbers_.at<int>(beside) = number;
                joined.push_back(beside);
            }
        }
        if (static_cast<int>(joined.size()) >= rules_.min_area)
            ++next_;
        else
            for (const cv::Point at : joined)
                numbers_.at<int>(at) = too_small;
    }

    static constexpr int too_small = -1;

    const PatchMatch& matches_;
    const IslandRules& rules_;
    cv::Mat numbers_;  // island number of each patch
    int next_ = 1;
};

}  // namespace

Islands find_islands(const cv::Mat& coarse, const cv::Mat& fine, const PlaceGuesses& guesses,
                     const IslandRules& rules, const RunTasks& run) {
    const PatchImage target(coarse);
    const PatchImage source(fine);
    const PatchRules patches = rules_for(source);
    PatchMatch matches(source, target, patches);
    begin_with(matches.of_target(), matches.of_source(), guesses.to_fine);
    begin_with(matches.of_source(), matches.of_target(), guesses.to_coarse);
    matches.refresh(run);
    for (int sweep = 0; sweep < sweeps; ++sweep)
        matches.search(std::max(1, rules.reach >> (2 * sweep)), static_cast<std::uint32_t>(sweep), run);

    const Joining joining(matches, rules);
    Islands islands{.number = cv::Mat(coarse.size(), CV_32SC1, cv::Scalar::all(0)),
                    .place = cv::Mat(coarse.size(), CV_32SC2, cv::Scalar::all(0))};
    for (int y = 0; y < joining.numbers().rows; ++y) {
        for (int x = 0; x < joining.numbers().cols; ++x) {
            const Match& match = matches.of_target().at(x, y);
            const cv::Point at(x + half_patch, y + half_patch);
            islands.number.at<int>(at) = std::max(0, joining.numbers().at<int>(y, x));
            islands.place.at<cv::Vec2i>(at) = {match.x + half_patch, match.y + half_patch};
        }
    }
    return islands;
}

}  // namespace vitrine::analyzer
