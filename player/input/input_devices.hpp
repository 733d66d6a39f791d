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

/// Reads the visitors' input devices in the event loop, and says on which screen each input is. Where there
/// are no devices, or no right to open them, it logs that once and does nothing.
class InputDevices {
  public:
    /// @param loop     outlives this
    /// @param devices  as the setting input.devices
    InputDevices(EventLoop& loop, const std::string& devices);

    using Call = std::function<void(const Screen&, InputEvent)>;

    /// Hands on the input since the last call.
    /// @param screens  all there are; a device that names none of them belongs to the first
    /// @param start    of the player; the events' times count from there
    /// @param call     gets places as shares of the screen, as in PanelEvent
    void deliver_input(std::span<Screen* const> screens, EventLoop::Clock::time_point start,
                       const Call& call);

    /// Leaves the devices to other programs: another terminal is in front.
    void suspend();

    /// Opens the devices again: our terminal is in front.
    void resume();

  private:
    void read();

    std::unique_ptr<Touch> touch_;  // none: there is no input
    EventLoop::Source readable_;
    std::vector<PanelEvent> events_;  // since the last delivery
    std::string logged_;              // the last line about a device
};

}  // namespace vitrine::player
