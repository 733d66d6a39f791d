#include "player/scene/acts/awaited_sources.hpp"

#include <utility>

namespace vitrine::player {

namespace {

constexpr std::chrono::nanoseconds patience_with_others = std::chrono::seconds(5);

}  // namespace

std::uint64_t AwaitedSources::prepare(std::chrono::nanoseconds now) {
    prepared_ = now;
    return ++preparations_;
}

bool AwaitedSources::is_waiting(std::chrono::nanoseconds now) const {
    return ready_ && *ready_ < preparations_ && now - prepared_ < patience_with_others;
}

std::set<SourceId> AwaitedSources::take_free(std::chrono::nanoseconds now) {
    return is_waiting(now) ? std::set<SourceId>() : std::exchange(held_, {});
}

}  // namespace vitrine::player
