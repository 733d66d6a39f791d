#pragma once

#include "player/input/contact.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// An input of one device. Places are shares of the panel's sides: (0, 0) is the top left and (1, 1) the
/// bottom right of its pixels, however the panel is mounted.
struct PanelEvent {
    std::string output;  // the device's output, from udev's WL_OUTPUT; empty: not given
    InputEvent event;    // its time counts from the machine's start
};

/// Reads touch panels, mice, tablets and keyboards over libinput, without a user's session: a member of the
/// group `input` may open the devices. Devices may come and go at any time.
class Touch {
  public:
    /// @param devices  "auto": all devices of seat0, from udev; else device nodes, separated by commas
    /// @throws std::runtime_error if udev or libinput cannot be used
    explicit Touch(const std::string& devices);
    Touch(const Touch&) = delete;
    Touch& operator=(const Touch&) = delete;
    Touch(Touch&&) = delete;
    Touch& operator=(Touch&&) = delete;
    ~Touch();

    /// Poll it for POLLIN, then call read_events().
    int event_fd() const;

    /// The input since the last call. @throws std::system_error if the devices cannot be read any more
    std::vector<PanelEvent> read_events();

    /// Lines for the log: devices that came, went or cannot be opened since the last call.
    std::vector<std::string> take_news();

    /// Leaves the devices to other programs until resume().
    void suspend();
    void resume();

  private:
    struct Context;

    std::unique_ptr<Context> context_;
};

}  // namespace vitrine::player
