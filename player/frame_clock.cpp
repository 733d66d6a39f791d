#include "player/frame_clock.hpp"

#include <algorithm>

namespace vitrine::player {

std::int64_t FrameClock::index_after(std::chrono::nanoseconds now) const {
    std::int64_t index = now.count() / 1'000 * rate_ / 1'000'000;
    while (due_of(index) <= now)
        ++index;
    return index;
}

void FrameClock::advance(std::chrono::nanoseconds now) {
    const std::int64_t next = std::max(index_ + 1, index_after(now));
    late_ += next - (index_ + 1);
    index_ = next;
}

void FrameClock::skip_to(std::chrono::nanoseconds now) {
    const std::int64_t next = std::max(index_, index_after(now));
    skipped_ += next - index_;
    index_ = next;
}

}  // namespace vitrine::player
