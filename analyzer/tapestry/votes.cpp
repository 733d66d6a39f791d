#include "analyzer/tapestry/votes.hpp"

#include <algorithm>

namespace vitrine {

namespace {

constexpr int band_rows = 32;  // px of the target that are one task

/// The votes for a band of rows: sums of B, G, R and of the weights, a pixel.
struct Ballot {
    const PatchMatch& matches;
    const PatchImage& source;
    const PatchRules& rules;
    PatchImage& target;
    const std::vector<float>& shares;  // a patch of the target: what a unit of weight counts
    int first;
    int last;
    std::vector<float> sums;
};

/// Of a value that is not negative; lround() would keep the loop from being vectorised.
[[gnu::always_inline]] inline std::uint8_t rounded(float value) {
    constexpr float half = 0.5F;
    const float raised = value + half;
    return static_cast<std::uint8_t>(raised);
}

[[gnu::always_inline]] inline std::size_t index(const MatchField& field, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(field.columns) +
           static_cast<std::size_t>(x);
}

[[gnu::always_inline]] inline void add_patch(Ballot& ballot, int source_x, int source_y, int target_x,
                                             int target_y, float weight) {
    const int from = std::max(0, ballot.first - target_y);
    const int to = std::min(patch_side, ballot.last - target_y);
    for (int y = from; y < to; ++y) {
        const std::uint8_t* values = ballot.source.at(source_x, source_y + y);
        float* sums =
            &ballot.sums[static_cast<std::size_t>(target_y + y - ballot.first) * ballot.target.stride() +
                         4 * static_cast<std::size_t>(target_x)];
        for (int i = 0; i < patch_row_bytes; ++i)
            sums[i] += weight * static_cast<float>(values[i]);
    }
}

[[gnu::always_inline]] inline void count(Ballot& ballot) {
    const MatchField& of_target = ballot.matches.of_target();
    const MatchField& of_source = ballot.matches.of_source();
    for (int y = std::max(0, ballot.first - patch_side + 1); y < std::min(ballot.last, of_target.rows); ++y) {
        for (int x = 0; x < of_target.columns; ++x) {
            const Match& match = of_target.at(x, y);
            add_patch(ballot, match.x, match.y, x, y, 1);
        }
    }
    for (int y = 0; y < of_source.rows; ++y) {
        for (int x = 0; x < of_source.columns; ++x) {
            const Match& match = of_source.at(x, y);
            if (match.x < 0 || match.y + patch_side <= ballot.first || match.y >= ballot.last) continue;
            const float weight = ballot.rules.weights[index(of_source, x, y)];
            add_patch(ballot, x, y, match.x, match.y,
                      weight * ballot.shares[index(of_target, match.x, match.y)]);
        }
    }
    for (int y = ballot.first; y < ballot.last; ++y) {
        const float* sums = &ballot.sums[static_cast<std::size_t>(y - ballot.first) * ballot.target.stride()];
        std::uint8_t* pixel = ballot.target.at(0, y);
        for (int x = 0; x < ballot.target.width(); ++x, sums += 4, pixel += 4)
            for (int c = 0; c < 3; ++c)
                pixel[c] = rounded(sums[c] / sums[3]);
    }
}

void count_plain(Ballot& ballot) {
    count(ballot);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void count_avx2(Ballot& ballot) {
    count(ballot);
}
#endif

/// What a unit of weight of the source counts, in votes of the target's own, for each patch of the target.
std::vector<float> shares_of(const PatchMatch& matches, const PatchRules& rules, float most_votes) {
    const MatchField& of_target = matches.of_target();
    const MatchField& of_source = matches.of_source();
    const auto usual = static_cast<float>(static_cast<double>(of_target.matches.size()) /
                                          std::max(1.0, matches.source_weight()));
    std::vector<float> shares(of_target.matches.size(), usual);
    if (most_votes <= 0) return shares;
    std::vector<float> votes(of_target.matches.size(), 0);
    for (std::size_t i = 0; i < of_source.matches.size(); ++i) {
        const Match& match = of_source.matches[i];
        if (match.x >= 0)
            votes[index(of_target, match.x, match.y)] += usual * static_cast<float>(rules.weights[i]);
    }
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (votes[i] > most_votes) shares[i] *= most_votes / votes[i];
    return shares;
}

}  // namespace

void take_votes(const PatchMatch& matches, const PatchImage& source, const PatchRules& rules,
                PatchImage& target, float most_votes, const RunTasks& run) {
    const std::vector<float> shares = shares_of(matches, rules, most_votes);
    run((target.height() + band_rows - 1) / band_rows, [&](int band) {
        const int first = band * band_rows;
        const int last = std::min(first + band_rows, target.height());
        Ballot ballot{.matches = matches,
                      .source = source,
                      .rules = rules,
                      .target = target,
                      .shares = shares,
                      .first = first,
                      .last = last,
                      .sums = std::vector<float>(static_cast<std::size_t>(last - first) * target.stride())};
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2")) {
            count_avx2(ballot);
            return;
        }
#endif
        count_plain(ballot);
    });
}

}  // namespace vitrine
