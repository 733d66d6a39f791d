#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

namespace vitrine::player {

/// Says when a shot shall show that it can be touched: nobody has touched the wall for a while.
class TouchHint {
  public:
    /// @param after  time alone until the first hint; 0: there are no hints
    explicit TouchHint(std::chrono::nanoseconds after) : after_(after) {}

    void note_touch(std::chrono::nanoseconds now) { since_ = now; }

    /// The number of the hint that is due. None: not yet.
    std::optional<std::size_t> next_hint(std::chrono::nanoseconds now) {
        if (after_ == std::chrono::nanoseconds(0) || now - since_ < after_) return std::nullopt;
        since_ = now - after_ + spacing;
        return count_++;
    }

  private:
    static constexpr std::chrono::nanoseconds spacing = std::chrono::seconds(10);  // between two hints

    std::chrono::nanoseconds after_;
    std::chrono::nanoseconds since_{0};  // of the last touch, or of what counts as one
    std::size_t count_ = 0;
};

}  // namespace vitrine::player
