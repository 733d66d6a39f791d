#include "analyzer/saliency/background_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace vitrine::analyzer {
namespace {

constexpr int magnitude_bins = 32;
constexpr int direction_bins = 16;
constexpr double still = 0.25;  // px: shorter vectors have no direction
constexpr int refits = 8;
constexpr double explained = 0.5;  // px: a vector this far off the background counts a quarter
constexpr std::size_t every = 3;   // one vector of so many takes part in the fit

struct Bin {
    int magnitude = 0;  // 0: still, whatever the direction
    int direction = 0;
};

Bin bin_of(Vec2 v, double step) {
    const double magnitude = length(v);
    if (magnitude < still) return {};
    const double turn = std::atan2(v.y, v.x) / (2 * std::numbers::pi) + 0.5;
    const int direction = static_cast<int>(turn * direction_bins) % direction_bins;
    return {std::clamp(1 + static_cast<int>((magnitude - still) / step), 1, magnitude_bins - 1), direction};
}

/// True where b is a or touches a; directions wrap, and all directions touch the still bin.
bool are_neighbours(Bin a, Bin b) {
    if (std::abs(a.magnitude - b.magnitude) > 1) return false;
    if (a.magnitude == 0 || b.magnitude == 0) return true;
    const int turn = std::abs(a.direction - b.direction);
    return std::min(turn, direction_bins - turn) <= 1;
}

using Votes = std::array<std::array<double, direction_bins>, magnitude_bins>;

double votes_around(const Votes& votes, Bin bin) {
    double sum = 0;
    for (int k = std::max(0, bin.magnitude - 1); k <= std::min(bin.magnitude + 1, magnitude_bins - 1); ++k) {
        for (int e = 0; e < direction_bins; ++e) {
            if (!are_neighbours(bin, {k, e})) continue;
            sum += votes[static_cast<std::size_t>(k)][static_cast<std::size_t>(e)];
        }
    }
    return sum;
}

Bin winning_bin(const Votes& votes) {
    Bin best;
    double most = -1;
    for (int m = 0; m < magnitude_bins; ++m) {
        for (int d = 0; d < (m == 0 ? 1 : direction_bins); ++d) {
            const double sum = votes_around(votes, {m, d});
            if (sum <= most) continue;
            most = sum;
            best = {m, d};
        }
    }
    return best;
}

struct Weighted {
    double value = 0;
    double weight = 0;
};

double weighted_median(std::vector<Weighted> values) {
    std::sort(values.begin(), values.end(), [](auto a, auto b) { return a.value < b.value; });
    double half = 0;
    for (const Weighted& v : values)
        half += v.weight / 2;
    for (const Weighted& v : values) {
        half -= v.weight;
        if (half <= 0) return v.value;
    }
    return 0;
}

/// One step of iterated least squares, each vector weighted by how well the motion so far explains it.
BackgroundMotion refitted(const FlowField& flow, std::span<const std::size_t> used,
                          const BackgroundMotion& now) {
    Vec2 sum_p;
    Vec2 sum_v;
    double sum = 0;
    std::vector<double> weights;
    for (const std::size_t i : used) {
        const double residual = length(flow.vectors[i] - now.at(flow.place(i))) / explained;
        const double weight = 1 / ((1 + residual * residual) * (1 + residual * residual));
        weights.push_back(weight);
        sum += weight;
        sum_p = sum_p + flow.place(i) * weight;
        sum_v = sum_v + flow.vectors[i] * weight;
    }
    if (sum <= 0) return now;
    BackgroundMotion next{.pan = sum_v * (1 / sum), .turn = {}, .centre = sum_p * (1 / sum)};
    double spread = 0;
    for (std::size_t k = 0; k < used.size(); ++k) {
        const Vec2 p = flow.place(used[k]) - next.centre;
        const Vec2 v = flow.vectors[used[k]] - next.pan;
        spread += weights[k] * dot(p, p);
        next.turn = next.turn + Vec2{dot(p, v), cross(p, v)} * weights[k];
    }
    next.turn = spread > 0 ? next.turn * (1 / spread) : Vec2{};
    return next;
}

}  // namespace

Vec2 voted_motion(std::span<const Vec2> vectors, std::span<const double> weights) {
    double fastest = 0;
    for (const Vec2 v : vectors)
        fastest = std::max(fastest, length(v));
    const double step = std::max(still, fastest / magnitude_bins);
    const auto weight = [&](std::size_t i) { return weights.empty() ? 1 : weights[i]; };
    std::vector<Bin> bins;
    Votes votes{};
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        bins.push_back(bin_of(vectors[i], step));
        const Bin bin = bins.back();
        votes[static_cast<std::size_t>(bin.magnitude)][static_cast<std::size_t>(bin.direction)] += weight(i);
    }
    const Bin best = winning_bin(votes);
    std::vector<Weighted> xs;
    std::vector<Weighted> ys;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        if (weight(i) <= 0 || !are_neighbours(best, bins[i])) continue;
        xs.push_back({vectors[i].x, weight(i)});
        ys.push_back({vectors[i].y, weight(i)});
    }
    return {weighted_median(std::move(xs)), weighted_median(std::move(ys))};
}

BackgroundMotion fitted_background(const FlowField& flow, Vec2 pan) {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < flow.vectors.size(); i += every) {
        if (flow.is_reliable[i]) used.push_back(i);
    }
    BackgroundMotion background{.pan = pan, .turn = {}, .centre = {}};
    for (int i = 0; i < refits; ++i)
        background = refitted(flow, used, background);
    return background;
}

}  // namespace vitrine::analyzer
