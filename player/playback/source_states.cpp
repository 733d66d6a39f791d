#include "player/playback/source_pool.hpp"

#include <algorithm>

// What the pool says of its sources to who asks, and how it is rid of them all.

namespace vitrine {

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
                          .is_film = playing.request.kind == MediaKind::video,
                          .detail = playing.source->detail(),
                          .is_stored = playing.is_stored,
                          .is_ready = playing.is_told_ready,
                          .late = playing.source->late()});
    return states;
}

std::size_t SourcePool::queue() const {
    const auto getting_ready = std::ranges::count_if(playing_, [](const auto& entry) {
        return !entry.second.is_told_ready && !entry.second.is_told_failed;
    });
    return waiting_.size() + static_cast<std::size_t>(getting_ready);
}

}  // namespace vitrine
