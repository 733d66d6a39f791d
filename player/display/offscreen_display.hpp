#pragma once

#include "player/display/display.hpp"
#include "player/display/offscreen_screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// The path of the file with this index: `path` itself for the first; further ones have a number before the
/// ending: "wall-2.mp4".
std::filesystem::path numbered(const std::filesystem::path& path, std::size_t index);

/// The screens in memory that `output.screen` asks for.
struct OffscreenChoice {
    std::vector<ScreenSize> screens;  // at least one
};

/// Screens in memory, "offscreen-1" and so on, that are always there.
class OffscreenDisplay final : public Display {
  public:
    /// @param recording  the first screen's files; the others' are numbered()
    /// @param rate       frames a second that are written into the films' headers
    /// @throws std::runtime_error if EGL cannot draw without a device, or a film cannot be written
    OffscreenDisplay(const OffscreenChoice& choice, Recording recording, double rate);

    std::span<Screen* const> screens() override { return lent_; }

    int event_fd() const override { return -1; }

    void dispatch() override {}

    bool is_gone() const override { return false; }

    void leave() override {}

    void take_back() override {}

    std::vector<DisplayEvent> take_events() override { return {}; }

    const std::shared_ptr<Egl>& gl() const override { return egl_; }

    std::string description() const override;

    /// Completes the films, and saves the last frames as the snapshots.
    std::vector<std::string> finish_recording() override;

  private:
    Recording recording_;
    std::shared_ptr<Egl> egl_;  // shared with the screens, which may be used without a display
    std::vector<std::unique_ptr<OffscreenScreen>> screens_;
    std::vector<Screen*> lent_;
};

/// Makes an opener of off-screen displays: "offscreen:1280x720+640x360".
/// @param argument  the text after the colon of `output.screen`
/// @return none: the argument is not understood
std::unique_ptr<DisplayOpener> make_offscreen_opener(std::optional<std::string_view> argument,
                                                     const DisplayRequest& request);

}  // namespace vitrine::player
