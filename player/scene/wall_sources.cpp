#include "player/scene/wall_sources.hpp"

#include <utility>

namespace vitrine::player {

std::vector<ShotRequest> WallSources::request(std::span<const PlacedShot> wall) {
    std::vector<ShotRequest> requests;
    for (const PlacedShot& placed : wall) {
        requests.push_back(request_of(placed));
        states_.try_emplace(placed.shot.source, State::pending);
    }
    return requests;
}

void WallSources::request_again(std::span<const ShotRequest> requests) {
    again_.insert(again_.end(), requests.begin(), requests.end());
}

std::vector<ShotRequest> WallSources::take_requests() {
    return std::exchange(again_, {});
}

void WallSources::set_ready(SourceId source) {
    set_state(source, State::ready);
}

void WallSources::set_failed(SourceId source) {
    set_state(source, State::failed);
}

void WallSources::set_state(SourceId source, State state) {
    const auto found = states_.find(source);
    if (found != states_.end()) found->second = state;
}

std::vector<SourceId> WallSources::pending(std::span<const PlacedShot> wall) const {
    std::vector<SourceId> pending;
    for (const PlacedShot& placed : wall)
        if (is(placed, State::pending)) pending.push_back(placed.shot.source);
    return pending;
}

std::vector<SourceId> WallSources::retire_all_but(const std::set<SourceId>& kept) {
    std::vector<SourceId> retired;
    for (const auto& [source, state] : states_)
        if (!kept.contains(source)) retired.push_back(source);
    for (const SourceId source : retired)
        states_.erase(source);
    return retired;
}

}  // namespace vitrine::player
