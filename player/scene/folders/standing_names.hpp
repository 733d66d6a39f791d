#pragma once

#include "player/scene/frame.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The names of the folders on a wall while nothing moves on it. They fade in. Knows no clock.
class StandingNames {
  public:
    /// The wall stands: names are placed, if they are not yet.
    /// @param taken  a box that stays free of them, canvas px
    void stand(std::span<const PlacedShot> wall, Vec2 canvas, const Box& taken, std::chrono::nanoseconds now);

    /// Something moves on the wall: there are no names.
    void hide() { since_.reset(); }

    /// The shots may be others: names are placed anew, and stay as bright as they are.
    void place_anew() { is_placed_ = false; }

    std::vector<FrameName> at(std::chrono::nanoseconds now) const;

  private:
    std::vector<FrameName> all_;
    bool is_placed_ = false;
    std::optional<std::chrono::nanoseconds> since_;  // none: nothing stands
};

}  // namespace vitrine::player
