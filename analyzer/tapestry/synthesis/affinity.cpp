#include "analyzer/tapestry/synthesis/affinity.hpp"

#include "analyzer/tapestry/synthesis/patch_scan.hpp"

#include <algorithm>
#include <limits>

namespace vitrine::analyzer {

namespace {

using Seconds = std::chrono::duration<double>;

// Lower bound of the median colour distance, so that time decides where all frames are alike.
constexpr float min_median = 1;

double seconds_between(const FrameSignature& a, const FrameSignature& b) {
    return Seconds(a.time - b.time).count();
}

/// The largest number of frames that lie within the band's time before a frame.
int band_of(std::span<const FrameSignature> frames, const AffinitySettings& settings) {
    const std::chrono::nanoseconds reach = settings.time_scale * settings.band_scales;
    std::size_t band = 0;
    for (std::size_t i = 0, j = 0; j < frames.size(); ++j) {
        while (frames[j].time - frames[i].time > reach)
            ++i;
        band = std::max(band, j - i);
    }
    return static_cast<int>(band);
}

/// Enters the colour distances between frame i and those frames of a block that come after it, both ways.
void scan_block(std::span<const FrameSignature> frames, const std::vector<FrameBlock>& blocks, int i,
                int block, Affinity& into) {
    const int from = block * scan_lanes;
    const int to = std::min({from + scan_lanes, into.last(i), into.frames()});
    const ScanResult result =
        scan_patches(frames[static_cast<std::size_t>(i)], blocks[static_cast<std::size_t>(block)]);
    for (int j = std::max(from, i + 1); j < to; ++j) {
        const auto lane = static_cast<std::size_t>(j - from);
        into.set(i, j, result.by_block[lane]);
        into.set(j, i, result.of_block[lane]);
    }
}

float median_cost(const Affinity& costs) {
    std::vector<float> all;
    const int step = 1 + costs.frames() / 2000;  // a million costs are enough for a median
    for (int j = 0; j < costs.frames(); j += step)
        for (int i = costs.first(j); i < costs.last(j); ++i)
            if (i != j) all.push_back(costs.at(i, j));
    if (all.empty()) return min_median;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return std::max(min_median, *middle);
}

/// Adds alpha (tau_i - tau_j)^2.
void add_time(std::span<const FrameSignature> frames, const AffinitySettings& settings, Affinity& costs) {
    const double usual = median_cost(costs);
    const double scale = Seconds(settings.time_scale).count();
    float most = 0;
    for (int j = 0; j < costs.frames(); ++j) {
        for (int i = costs.first(j); i < costs.last(j); ++i) {
            const double away =
                seconds_between(frames[static_cast<std::size_t>(i)], frames[static_cast<std::size_t>(j)]) /
                scale;
            const auto cost = static_cast<float>(costs.at(i, j) + usual * away * away);
            costs.set(i, j, cost);
            most = std::max(most, cost);
        }
    }
    const auto at_edge = static_cast<float>(usual * settings.band_scales * settings.band_scales);
    costs.set_far(2 * std::max(most, at_edge));
}

}  // namespace

Affinity::Affinity(int frames, int band)
    : frames_(frames),
      band_(std::clamp(band, 0, std::max(0, frames - 1))),
      costs_(as_index(frames) * as_index(2 * band_ + 1), 0.F) {}

Affinity affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings,
                  const RunTasks& run) {
    const int count = static_cast<int>(frames.size());
    Affinity costs(count, band_of(frames, settings));
    std::vector<FrameBlock> blocks;
    for (std::size_t i = 0; i < frames.size(); i += scan_lanes)
        blocks.push_back(
            frame_block(frames.subspan(i, std::min<std::size_t>(scan_lanes, frames.size() - i))));
    run(count, [&](int i) {
        for (int block = (i + 1) / scan_lanes; block * scan_lanes < costs.last(i); ++block)
            scan_block(frames, blocks, i, block, costs);
    });
    add_time(frames, settings, costs);
    return costs;
}

Affinity time_affinity(std::span<const FrameSignature> frames, const AffinitySettings& settings) {
    Affinity costs(static_cast<int>(frames.size()), band_of(frames, settings));
    add_time(frames, settings, costs);
    return costs;
}

}  // namespace vitrine::analyzer
