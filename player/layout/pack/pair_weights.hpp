#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A pair of items that overlap or are out of order.
struct Conflict {
    std::size_t a = 0, b = 0;  // a > b
    double size = 0;           // canvas px that the pair needs to be free, > 0
};

/// A weight for each pair of items. After each round of a search the weights of pairs that still conflict
/// rise and the others decay to 1; so the search leaves local minima.
class PairWeights {
  public:
    explicit PairWeights(std::size_t size) : size_(size), weights_(size * size, 1) {}

    /// The weights of an item with every other item.
    std::span<float> row(std::size_t item) { return {weights_.data() + item * size_, size_}; }

    /// Sets all weights to 1.
    void reset();

    /// Raises the weights of the conflicting pairs, and lowers the raised weights of the others.
    void update(std::span<const Conflict> conflicts);

  private:
    std::size_t size_;
    std::vector<float> weights_;                               // at [a * size + b] and [b * size + a]
    std::vector<std::pair<std::size_t, std::size_t>> raised_;  // pairs whose weight is above 1
};

}  // namespace vitrine::player
