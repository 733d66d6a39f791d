#include "player/playback/source_pool.hpp"

#include <algorithm>

// What the pool says of its sources to who asks and to itself, and how it is rid of them all.

namespace vitrine::player {

namespace {

constexpr long most_at_once = 3;        // sources that are read to their first picture
constexpr std::size_t most_stuck = 32;  // beside them; each has a thread

}  // namespace

std::vector<SourceId> SourcePool::retire_all() {
    std::vector<SourceId> all;
    for (const auto& [id, playing] : playing_)
        all.push_back(id);
    for (const SourceId id : all)
        retire(id);
    waiting_.clear();
    return all;
}

std::vector<SourceState> SourcePool::states() const {
    std::vector<SourceState> states;
    for (const auto& [id, playing] : playing_)
        states.push_back({.path = playing.request.path,
                          .is_film = playing.request.kind == MediaKind::film,
                          .detail = playing.source->detail(),
                          .is_stored = playing.is_stored,
                          .is_ready = playing.is_told_ready,
                          .late = playing.source->late()});
    return states;
}

std::size_t SourcePool::queue() const {
    const auto getting_ready =
        std::ranges::count_if(playing_, [](const auto& entry) { return entry.second.is_preparing(); });
    return waiting_.size() + static_cast<std::size_t>(getting_ready);
}

bool SourcePool::is_stuck(const Playing& playing) const {
    return playing.is_preparing() &&
           std::chrono::steady_clock::now() - playing.opened > options_.opening_patience;
}

/// Those that others wait for.
long SourcePool::count_preparing() const {
    return std::ranges::count_if(playing_, [this](const auto& entry) {
        return entry.second.is_preparing() && !is_stuck(entry.second);
    });
}

bool SourcePool::may_start() const {
    const auto stuck =
        std::ranges::count_if(playing_, [this](const auto& entry) { return is_stuck(entry.second); });
    return count_preparing() < most_at_once && static_cast<std::size_t>(stuck) + ending_.size() < most_stuck;
}

}  // namespace vitrine::player
