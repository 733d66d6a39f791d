#pragma once

#include "base/system/event_loop.hpp"
#include "player/display/screen.hpp"
#include "player/input/touch.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// Those who touch the wall: reads their devices in the event loop, and says on which screen they do what.
/// Where there are no devices, or no right to them, it says so once and does nothing.
class Visitors {
  public:
    /// @param devices  as the setting input.devices
    /// @param loop     outlives this
    Visitors(EventLoop& loop, const std::string& devices);

    /// What was done since the last call.
    /// @param screens  those there are; a device that names none belongs to the first
    /// @param start    of the player, that the events' times count from
    /// @param take     gets places as shares of the screen, as PanelEvent
    void hand_out(std::span<Screen* const> screens, EventLoop::Clock::time_point start,
                  const std::function<void(const Screen&, InputEvent)>& take);

    /// Another terminal is in front, ours is again.
    void leave();
    void come_back();

  private:
    void read();

    std::unique_ptr<Touch> touch_;  // none: nobody can touch
    EventLoop::Source readable_;
    std::vector<PanelEvent> events_;
    std::string told_;  // last complaint
};

}  // namespace vitrine::player
