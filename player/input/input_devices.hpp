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

/// Reads the visitors' input devices in the event loop, and finds the screen of each input. Without devices,
/// or without the right to open them, it logs that once and does nothing.
class InputDevices {
  public:
    /// @param loop     outlives this
    /// @param devices  the value of the setting input.devices
    InputDevices(EventLoop& loop, const std::string& devices);

    /// True: there is input since the last delivery.
    bool has_input() const { return !events_.empty(); }

    using Call = std::function<void(const Screen&, InputEvent)>;

    /// Passes on the input since the last call.
    /// @param screens  all screens; a device that names none of them belongs to the first
    /// @param start    the player's start; the events' times count from there
    /// @param call     gets places as shares of the screen's sides, as in PanelEvent
    void deliver_input(std::span<Screen* const> screens, EventLoop::Clock::time_point start,
                       const Call& call);

    /// Leaves the devices to other programs, because another terminal is in front.
    void suspend();

    /// Opens the devices again, because our terminal is in front.
    void resume();

  private:
    void read();

    std::unique_ptr<Touch> touch_;  // none: there is no input device
    EventLoop::Source readable_;
    std::vector<PanelEvent> events_;  // input since the last delivery
    std::string logged_;              // the last logged line about a device
};

}  // namespace vitrine::player
