#pragma once

#include "player/input/contact.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// An event of a device. Places are shares of the panel, (0, 0) its top left and (1, 1) its bottom right as
/// its pixels lie, whatever way it is hung.
struct PanelEvent {
    std::string output;  // that the device belongs to, by udev's WL_OUTPUT; empty: not said
    InputEvent event;    // times since the machine's start
};

/// Touch panels, mice, tablets and keyboards, over libinput and without a session of anybody's: the devices
/// are opened by who is in the group `input`. They come and go at any time.
class Touch {
  public:
    /// @param devices  "auto": all of seat0, as udev says; else device nodes, separated by commas
    /// @throws std::runtime_error where there can be no input
    explicit Touch(const std::string& devices);
    Touch(const Touch&) = delete;
    Touch& operator=(const Touch&) = delete;
    Touch(Touch&&) = delete;
    Touch& operator=(Touch&&) = delete;
    ~Touch();

    /// To be polled for POLLIN, then events() called.
    int event_fd() const;

    std::vector<PanelEvent> events();

    /// What has become of the devices since the last call, in plain words for the log.
    std::vector<std::string> take_news();

    /// The devices are left to others until come_back(): another terminal is in front.
    void leave();
    void come_back();

  private:
    struct Context;

    std::unique_ptr<Context> context_;
};

}  // namespace vitrine::player
