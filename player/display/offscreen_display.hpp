#pragma once

#include "player/display/offscreen_screen.hpp"
#include "player/display/screen.hpp"
#include "player/display/screen_choice.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine::player {

/// `path` for the first of several files; with a number before its ending for each further one: "wall-2.mp4".
std::filesystem::path numbered(const std::filesystem::path& path, std::size_t index);

/// Screens in memory, "offscreen-1" and so on, that are always there.
class OffscreenDisplay final : public Display {
  public:
    /// @param film  of the first screen; the others' are numbered()
    /// @param rate  pictures a second that the films are told to hold
    /// @throws std::runtime_error where EGL cannot draw without a device, or a film cannot be written
    OffscreenDisplay(const OffscreenChoice& choice, const std::optional<std::filesystem::path>& film,
                     double rate);

    std::span<Screen* const> screens() override { return lent_; }

    int event_fd() const override { return -1; }

    void dispatch() override {}

    bool is_gone() const override { return false; }

    void leave() override {}

    void take_back() override {}

    std::vector<DisplayEvent> take_events() override { return {}; }

    const std::shared_ptr<Egl>& gl() const override { return egl_; }

    std::string description() const override;

    /// Ends the films, so that the files are whole.
    /// @throws std::runtime_error naming the film
    void finish_films();

    /// What the screens show now, the first one's into `path`, the others' numbered().
    /// @throws std::runtime_error naming the file
    void save(const std::filesystem::path& path);

  private:
    std::shared_ptr<Egl> egl_;  // shared with the screens, which may be used without a display
    std::vector<std::unique_ptr<OffscreenScreen>> screens_;
    std::vector<Screen*> lent_;
};

}  // namespace vitrine::player
