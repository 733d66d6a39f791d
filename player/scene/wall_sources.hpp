#pragma once

#include "player/scene/wall_shot.hpp"

#include <map>
#include <set>
#include <span>
#include <vector>

namespace vitrine::player {

/// The sources that a wall has requested and not retired, each with its state.
class WallSources {
  public:
    /// Requests the sources of these shots, each in its present size.
    std::vector<ShotRequest> request(std::span<const PlacedShot> wall);

    /// Requests playing shots once more, as their place in the store has changed.
    void request_again(std::span<const ShotRequest> requests);

    /// The requests of request_again() since the last call.
    std::vector<ShotRequest> take_requests();

    void set_ready(SourceId source);
    void set_failed(SourceId source);

    bool is_ready(const PlacedShot& placed) const { return is(placed, State::ready); }

    bool has_failed(const PlacedShot& placed) const { return is(placed, State::failed); }

    /// The sources of these shots that are neither ready nor failed.
    std::vector<SourceId> pending(std::span<const PlacedShot> wall) const;

    /// Retires all other sources and returns them.
    std::vector<SourceId> retire_all_but(const std::set<SourceId>& kept);

  private:
    enum class State { pending, ready, failed };

    bool is(const PlacedShot& placed, State state) const { return states_.at(placed.shot.source) == state; }

    void set_state(SourceId source, State state);

    std::map<SourceId, State> states_;
    std::vector<ShotRequest> again_;
};

}  // namespace vitrine::player
