#include "analyzer/tapestry/synthesis/zoom_votes.hpp"

#include <algorithm>

namespace vitrine::analyzer {

namespace {

constexpr int band_rows = 32;  // rows of the picture in one task

/// The votes for a band of rows.
struct Band {
    const MatchField& matches;
    const PatchImage& source;
    const std::vector<float>& weights;
    float* sums;  // the whole picture's
    std::size_t stride;
    int first;
    int last;
};

[[gnu::always_inline]] inline void add(const Band& band) {
    const MatchField& field = band.matches;
    for (int y = std::max(0, band.first - patch_side + 1); y < std::min(band.last, field.rows); ++y) {
        for (int x = 0; x < field.columns; ++x) {
            const Match& match = field.at(x, y);
            if (match.x < 0) continue;
            const float weight =
                band.weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.columns) +
                             static_cast<std::size_t>(x)];
            for (int row = std::max(0, band.first - y); row < std::min(patch_side, band.last - y); ++row) {
                const std::uint8_t* values = band.source.at(match.x, match.y + row);
                float* sums = band.sums + static_cast<std::size_t>(y + row) * band.stride +
                              4 * static_cast<std::size_t>(x);
                for (int i = 0; i < patch_row_bytes; ++i)
                    sums[i] += weight * static_cast<float>(values[i]);
            }
        }
    }
}

void add_plain(const Band& band) {
    add(band);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void add_avx2(const Band& band) {
    add(band);
}
#endif

}  // namespace

ZoomVotes::ZoomVotes(int width, int height)
    : width_(width),
      height_(height),
      sums_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void ZoomVotes::add(const MatchField& of_target, const PatchImage& source, const std::vector<float>& weights,
                    const RunTasks& run) {
    run((height_ + band_rows - 1) / band_rows, [&](int number) {
        const Band band{.matches = of_target,
                        .source = source,
                        .weights = weights,
                        .sums = sums_.data(),
                        .stride = 4 * static_cast<std::size_t>(width_),
                        .first = number * band_rows,
                        .last = std::min((number + 1) * band_rows, height_)};
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2")) return add_avx2(band);
#endif
        add_plain(band);
    });
}

}  // namespace vitrine::analyzer
