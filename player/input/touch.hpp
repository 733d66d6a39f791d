#pragma once

#include "player/input/contact.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// An input of one device. Places are shares of the panel: (0, 0) is its top left and (1, 1) its bottom right
/// as its pixels lie, whichever way it is hung.
struct PanelEvent {
    std::string output;  // the device's output by udev's WL_OUTPUT; empty: not said
    InputEvent event;    // its time counts from the machine's start
};

/// Reads touch panels, mice, tablets and keyboards over libinput, without a user's session: a member of the
/// group `input` may open the devices. Devices come and go at any time.
class Touch {
  public:
    /// @param devices  "auto": all of seat0, as udev says; else device nodes, separated by commas
    /// @throws std::runtime_error where udev or libinput cannot be used
    explicit Touch(const std::string& devices);
    Touch(const Touch&) = delete;
    Touch& operator=(const Touch&) = delete;
    Touch(Touch&&) = delete;
    Touch& operator=(Touch&&) = delete;
    ~Touch();

    /// To be polled for POLLIN; then read_events() is to be called.
    int event_fd() const;

    /// The input since the last call. @throws std::system_error where the devices cannot be read any more
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
