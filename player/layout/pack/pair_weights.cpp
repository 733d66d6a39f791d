#include "player/layout/pack/pair_weights.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr double weight_decay = 0.95;
constexpr double min_rise = 1.2;  // factor of a colliding pair's weight; max_rise for the deepest pair
constexpr double max_rise = 2.0;
constexpr float max_weight = 1e6F;

}  // namespace

void PairWeights::reset() {
    std::fill(weights_.begin(), weights_.end(), 1.0F);
    raised_.clear();
}

void PairWeights::update(std::span<const Conflict> conflicts) {
    double largest = 0;
    for (const Conflict& c : conflicts)
        largest = std::max(largest, c.size);
    for (const Conflict& c : conflicts) {
        if (row(c.a)[c.b] == 1) raised_.push_back({c.a, c.b});
        const double factor = min_rise + (max_rise - min_rise) * c.size / largest;
        row(c.a)[c.b] *= static_cast<float>(factor / weight_decay);  // the decay below applies to it as well
    }
    std::erase_if(raised_, [&](const std::pair<std::size_t, std::size_t>& pair) {
        const float lowered = row(pair.first)[pair.second] * static_cast<float>(weight_decay);
        const float weight = std::clamp(lowered, 1.0F, max_weight);
        row(pair.first)[pair.second] = row(pair.second)[pair.first] = weight;
        return weight == 1;
    });
}

}  // namespace vitrine::player
