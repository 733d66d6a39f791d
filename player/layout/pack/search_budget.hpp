#pragma once

#include <cstdint>
#include <functional>
#include <random>

namespace vitrine::player {

/// The random engine of all layouts.
using Random = std::mt19937_64;

/// Uniform in [0, 1), the same on every platform.
inline double uniform(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Uniform in [0, count). @pre count > 0
inline std::size_t uniform_index(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random() % count);
}

/// The number of evaluated moves that a search may still make. A move is one place tried for one item. A
/// search knows no clock. A caller with a clock passes `should_stop`, which is called now and then.
class SearchBudget {
  public:
    explicit SearchBudget(std::int64_t moves, std::function<bool()> should_stop = {})
        : left_(moves), should_stop_(std::move(should_stop)) {}

    void spend(std::int64_t moves = 1) {
        left_ -= moves;
        until_asked_ -= moves;
        if (until_asked_ > 0) return;
        until_asked_ = moves_between_questions;
        if (should_stop_ && should_stop_()) left_ = 0;
    }

    bool is_spent() const { return left_ <= 0; }

    std::int64_t left() const { return left_; }

  private:
    static constexpr std::int64_t moves_between_questions = 1000;  // about 1 ms

    std::int64_t left_;
    std::int64_t until_asked_ = moves_between_questions;
    std::function<bool()> should_stop_;
};

}  // namespace vitrine::player
