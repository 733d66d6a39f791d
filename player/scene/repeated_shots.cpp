#include "player/scene/repeated_shots.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace vitrine::player {

std::vector<WallShot> RepeatedShots::with_copies(std::vector<WallShot> shots, std::size_t displays) {
    std::map<Copy, SourceId> before = std::exchange(sources_, {});
    if (shots.empty() || displays <= 1) return shots;
    std::vector<int> slots;  // each once
    for (const WallShot& shot : shots)
        if (std::ranges::find(slots, shot.slot) == slots.end()) slots.push_back(shot.slot);
    const std::set<int> taken(slots.begin(), slots.end());
    const std::size_t count = shots.size();
    int free = 0;
    for (std::size_t shown = slots.size(); shown < displays; ++shown) {
        while (taken.contains(free))
            ++free;
        for (std::size_t i = 0; i < count; ++i) {
            if (shots[i].slot != slots[shown % slots.size()]) continue;
            const Copy copy{shots[i].source, shown / slots.size()};
            const auto known = before.find(copy);
            const SourceId source = known != before.end() ? known->second : ++*numbers_;
            sources_.emplace(copy, source);
            WallShot repeated = shots[i];
            repeated.source = source;
            repeated.slot = free;
            shots.push_back(std::move(repeated));
        }
        ++free;
    }
    std::erase_if(shots, [&](const WallShot& shot) {
        return hidden_.contains(shot.source) && is_seen_elsewhere(shot.source);
    });
    return shots;
}

SourceId RepeatedShots::original_of(SourceId source) const {
    const auto found =
        std::ranges::find_if(sources_, [&](const auto& copy) { return copy.second == source; });
    return found == sources_.end() ? source : found->first.first;
}

/// True if another copy of the same shot is not hidden.
bool RepeatedShots::is_seen_elsewhere(SourceId source) const {
    const SourceId original = original_of(source);
    if (original != source && !hidden_.contains(original)) return true;
    return std::ranges::any_of(sources_, [&](const auto& copy) {
        return copy.first.first == original && copy.second != source && !hidden_.contains(copy.second);
    });
}

bool RepeatedShots::hide(SourceId source, std::chrono::nanoseconds until) {
    if (!is_seen_elsewhere(source)) return false;
    hidden_[source] = until;
    return true;
}

void RepeatedShots::advance(std::chrono::nanoseconds now) {
    std::erase_if(hidden_, [&](const auto& hidden) { return hidden.second <= now; });
}

}  // namespace vitrine::player
