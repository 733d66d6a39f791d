#pragma once

#include "base/settings/choices.hpp"
#include "base/system/event_loop.hpp"
#include "player/scene/acts/wall_clock.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The time since a player's start. A box that shows its wall alone counts by its own steady clock; one that
/// shares a wall counts by the time that all its boxes share. A leader's clock is the one that the others
/// follow, so it is right by definition.
class SharedClock {
  public:
    explicit SharedClock(WallRole role);

    /// Call when the run begins: alone, the time counts from here.
    void begin();

    /// Looks at the clocks. @param may_jump  nothing moves on the wall now
    void follow(bool may_jump);

    std::chrono::nanoseconds now() const;

    /// The moment of the steady clock at which now() is 0, as far as now() goes on as it does.
    EventLoop::Clock::time_point start() const { return EventLoop::Clock::now() - now(); }

    /// None: the time is not shared.
    const std::optional<WallClock>& shared() const { return shared_; }

  private:
    ClockReading read() const;

    WallRole role_;
    EventLoop::Clock::time_point start_ = EventLoop::Clock::now();
    EventLoop::Clock::time_point read_ = start_;  // when the clocks were read last
    EventLoop::Clock::time_point asked_{};        // when the kernel was asked if the clock is right
    bool is_kept_ = false;
    std::optional<WallClock> shared_;
};

}  // namespace vitrine::player
