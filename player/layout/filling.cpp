#include "player/layout/filling.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace vitrine {

namespace {

constexpr int samples = 64;  // a side; a row is one word
constexpr double good_enough = 0.002;
constexpr double nearest = 0.01;  // of the field's diagonal, of a random move
constexpr double farthest = 0.3;

/// The samples with `from` <= centre < `to`, as a range of indices.
std::array<int, 2> sample_range(double from, double to, double origin, double size) {
    const auto index = [&](double x) {
        return static_cast<int>(
            std::clamp(std::ceil((x - origin) / size * samples - 0.5), 0.0, 1.0 * samples));
    };
    return {index(from), index(to)};
}

std::uint64_t bits_below(int count) {
    return count >= samples ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

Vec2 random_way(const Ground& ground, Random& random) {
    const double most = length(ground.field.max - ground.field.min);
    const double reach = most * nearest * std::pow(farthest / nearest, uniform(random));
    const double x = (2 * uniform(random) - 1) * reach;
    const double y = (2 * uniform(random) - 1) * reach;
    const std::size_t kind = uniform_index(random, 4);  // 0: along x only, 1: along y only
    return {kind == 1 ? 0 : x, kind == 0 ? 0 : y};
}

/// Random moves at one growth.
void climb(const Ground& ground, std::span<const Box> frames, Arrangement& arrangement, Contacts& contacts,
           Random& random, Effort& effort) {
    const auto tries = static_cast<int>(200 * (ground.size() + 1));
    contacts.set_scales(scales_at(ground, arrangement.growth));
    double now = unfilled(ground, frames, arrangement);
    for (int k = 0; k < tries && now > good_enough && !effort.is_spent(); ++k) {
        const std::size_t item = uniform_index(random, ground.size());
        if (ground.pinned[item]) continue;
        const Vec2 before = arrangement.places[item];
        const Vec2 place = held(before + random_way(ground, random), ground.range(item, arrangement.growth));
        effort.spend();
        if (!may_stand(ground, contacts, arrangement, item, place)) continue;
        arrangement.places[item] = place;
        const double there = unfilled(ground, frames, arrangement);
        if (there > now) arrangement.places[item] = before;
        now = std::min(now, there);
    }
}

}  // namespace

double unfilled(const Ground& ground, std::span<const Box> frames, const Arrangement& arrangement) {
    std::array<std::uint64_t, samples> rows{};
    for (std::size_t i = 0; i < ground.size(); ++i) {
        const double scale = ground.scale(i, arrangement.growth);
        const Vec2 low = arrangement.places[i] + frames[i].min * scale;
        const Vec2 high = arrangement.places[i] + frames[i].max * scale;
        const auto [left, right] = sample_range(low.x, high.x, ground.field.min.x, ground.field.width());
        const auto [top, bottom] = sample_range(low.y, high.y, ground.field.min.y, ground.field.height());
        if (left >= right) continue;
        for (int y = top; y < bottom; ++y)
            rows[static_cast<std::size_t>(y)] |= bits_below(right) & ~bits_below(left);
    }
    int covered = 0;
    for (const std::uint64_t row : rows)
        covered += std::popcount(row);
    return 1 - static_cast<double>(covered) / (samples * samples);
}

Arrangement filled(const Ground& ground, std::span<const Box> frames, const Arrangement& start,
                   Random& random, Effort& effort) {
    if (ground.size() == 0) return start;
    Contacts contacts(ground.shapes, ground.clearance);
    const auto cost = [&](const Arrangement& arrangement) {
        return unfilled(ground, frames, arrangement) -
               region_area(ground, arrangement.growth) / ground.field.area();
    };
    Arrangement best = start;
    Arrangement trial = start;
    for (const double growth : {1.0, 0.97, 0.94, 0.9, 0.86, 0.8}) {
        trial.growth = start.growth * growth;
        climb(ground, frames, trial, contacts, random, effort);
        if (cost(trial) < cost(best) && is_free(ground, trial, contacts)) best = trial;
        if (unfilled(ground, frames, best) <= good_enough || effort.is_spent()) break;
    }
    return best;
}

}  // namespace vitrine
