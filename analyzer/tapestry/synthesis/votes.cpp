#include "analyzer/tapestry/synthesis/votes.hpp"

#include <algorithm>

namespace vitrine::analyzer {

namespace {

constexpr int band_rows = 32;  // rows of the target in one task

/// The votes for a band of rows: sums of B, G, R and of the weights, a pixel.
struct Ballot {
    const PatchMatch& matches;
    const PatchImage& source;
    const PatchRules& rules;
    PatchImage& target;
    float share;  // votes for one unit of the source's weight
    int first;
    int last;
    std::vector<float> sums;
    std::vector<float> shares_of_run;  // votes of each value of a run
};

/// Rounds a value that is not negative. lround() would keep the loop from being vectorised.
[[gnu::always_inline]] inline std::uint8_t rounded(float value) {
    constexpr float half = 0.5F;
    const float raised = value + half;
    return static_cast<std::uint8_t>(raised);
}

[[gnu::always_inline]] inline std::size_t index(const MatchField& field, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(field.columns) +
           static_cast<std::size_t>(x);
}

/// Patches side by side in one picture that are matched with patches side by side in the other. They vote at
/// once.
struct Run {
    int source_x;
    int source_y;
    int target_x;
    int target_y;
    int length;  // patches
};

/// @param weights  the votes of each patch of the run, then patch_side - 1 zeros
[[gnu::always_inline]] inline void add_run(Ballot& ballot, const Run& run, const float* weights) {
    const int width = run.length + patch_side - 1;
    float covering = 0;
    for (int i = 0; i < width; ++i) {
        covering += weights[i];
        std::fill_n(&ballot.shares_of_run[4 * static_cast<std::size_t>(i)], 4, covering);
        if (i >= patch_side - 1) covering -= weights[i - patch_side + 1];
    }
    const int from = std::max(0, ballot.first - run.target_y);
    const int to = std::min(patch_side, ballot.last - run.target_y);
    const float* shares = ballot.shares_of_run.data();
    for (int y = from; y < to; ++y) {
        const std::uint8_t* values = ballot.source.at(run.source_x, run.source_y + y);
        float* sums =
            &ballot.sums[static_cast<std::size_t>(run.target_y + y - ballot.first) * ballot.target.stride() +
                         4 * static_cast<std::size_t>(run.target_x)];
        for (int i = 0; i < 4 * width; ++i)
            sums[i] += shares[i] * static_cast<float>(values[i]);
    }
}

/// The number of patches from (x, y) on whose matches lie side by side.
[[gnu::always_inline]] inline int run_length(const MatchField& field, int x, int y) {
    const Match& begin = field.at(x, y);
    int length = 1;
    while (x + length < field.columns && field.at(x + length, y).x == begin.x + length &&
           field.at(x + length, y).y == begin.y)
        ++length;
    return length;
}

/// Adds the votes of the target's own patches: each counts 1.
[[gnu::always_inline]] inline void add_target_votes(Ballot& ballot) {
    const MatchField& of_target = ballot.matches.of_target();
    std::vector<float> ones(static_cast<std::size_t>(of_target.columns + patch_side), 1);
    for (int y = std::max(0, ballot.first - patch_side + 1); y < std::min(ballot.last, of_target.rows); ++y) {
        for (int x = 0; x < of_target.columns;) {
            const Match& match = of_target.at(x, y);
            const Run run{.source_x = match.x,
                          .source_y = match.y,
                          .target_x = x,
                          .target_y = y,
                          .length = run_length(of_target, x, y)};
            std::fill_n(ones.begin() + run.length, patch_side - 1, 0.F);
            add_run(ballot, run, ones.data());
            std::fill_n(ones.begin() + run.length, patch_side - 1, 1.F);
            x += run.length;
        }
    }
}

/// Adds the votes of the source's patches: each counts its weight times Ballot::share.
[[gnu::always_inline]] inline void add_source_votes(Ballot& ballot) {
    const MatchField& of_source = ballot.matches.of_source();
    std::vector<float> weights(static_cast<std::size_t>(of_source.columns + patch_side), 0);
    for (int y = 0; y < of_source.rows; ++y) {
        for (int x = 0; x < of_source.columns;) {
            const Match& match = of_source.at(x, y);
            const int length = match.x < 0 ? 1 : run_length(of_source, x, y);
            if (match.x >= 0 && match.y + patch_side > ballot.first && match.y < ballot.last) {
                for (int i = 0; i < length; ++i)
                    weights[static_cast<std::size_t>(i)] =
                        ballot.share * static_cast<float>(ballot.rules.weights[index(of_source, x + i, y)]);
                std::fill_n(weights.begin() + length, patch_side - 1, 0.F);
                add_run(ballot,
                        {.source_x = x,
                         .source_y = y,
                         .target_x = match.x,
                         .target_y = match.y,
                         .length = length},
                        weights.data());
            }
            x += length;
        }
    }
}

/// Gives each pixel of the band the mean of its votes.
[[gnu::always_inline]] inline void write_means(Ballot& ballot) {
    for (int y = ballot.first; y < ballot.last; ++y) {
        const float* sums = &ballot.sums[static_cast<std::size_t>(y - ballot.first) * ballot.target.stride()];
        std::uint8_t* pixel = ballot.target.at(0, y);
        for (int x = 0; x < ballot.target.width(); ++x, sums += 4, pixel += 4)
            for (int c = 0; c < 3; ++c)
                pixel[c] = rounded(sums[c] / sums[3]);
    }
}

[[gnu::always_inline]] inline void count(Ballot& ballot) {
    add_target_votes(ballot);
    add_source_votes(ballot);
    write_means(ballot);
}

void count_plain(Ballot& ballot) {
    count(ballot);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void count_avx2(Ballot& ballot) {
    count(ballot);
}
#endif

}  // namespace

void take_votes(const PatchMatch& matches, const PatchImage& source, const PatchRules& rules,
                PatchImage& target, const RunTasks& run) {
    // Votes for one unit of the source's weight, where each patch of the target has one vote.
    const auto share = static_cast<float>(static_cast<double>(matches.of_target().matches.size()) /
                                          std::max(1.0, matches.source_weight()));
    run((target.height() + band_rows - 1) / band_rows, [&](int band) {
        const int first = band * band_rows;
        const int last = std::min(first + band_rows, target.height());
        Ballot ballot{.matches = matches,
                      .source = source,
                      .rules = rules,
                      .target = target,
                      .share = share,
                      .first = first,
                      .last = last,
                      .sums = std::vector<float>(static_cast<std::size_t>(last - first) * target.stride()),
                      .shares_of_run = std::vector<float>(4 * static_cast<std::size_t>(target.width()))};
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2")) {
            count_avx2(ballot);
            return;
        }
#endif
        count_plain(ballot);
    });
}

}  // namespace vitrine::analyzer
