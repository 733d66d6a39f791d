#pragma once

#include "base/settings/output_words.hpp"
#include "base/settings/settings.hpp"
#include "player/display/egl.hpp"
#include "player/display/screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// News of a display, for the log.
struct DisplayEvent {
    bool is_trouble = false;
    std::string text;  // "visible 1920x1080 on HDMI-A-1 at 60.00 Hz"
};

/// A graphics card with its panels, or memory instead. All its screens share one EGL context, which is
/// current for as long as the display lives. One of the two true seams of the player.
class Display {
  public:
    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    Display(Display&&) = delete;
    Display& operator=(Display&&) = delete;
    virtual ~Display() = default;

    /// The screens to draw on now, always in the same order. None: there is no panel, or another program has
    /// the card. Lent until the next call.
    virtual std::span<Screen* const> screens() = 0;

    /// The descriptor to poll for POLLIN between frames, before dispatch() is called; -1: none.
    virtual int event_fd() const = 0;
    virtual void dispatch() = 0;

    /// True once the card was pulled out: this display never shows a picture again. The owner destroys all GL
    /// objects, unless has_lasting_gl(), then the display, and may open another one.
    virtual bool is_gone() const = 0;

    /// True while another program, or another terminal, has the card: nothing is shown on purpose.
    virtual bool is_away() const { return false; }

    /// Leaves the card to other programs until take_back().
    virtual void leave() = 0;
    virtual void take_back() = 0;

    /// True while it shows a picture of an earlier run. That picture stays until a frame is presented.
    virtual bool has_old_picture() const { return false; }

    /// Call when the program ends in order: the shown picture stays for the next process. False: it cannot
    /// stay.
    virtual bool keep_picture() { return false; }

    /// Call when the program ends in order: completes the files that the run was asked for (`Recording`).
    /// @return one line for the log per file
    /// @throws std::runtime_error naming the file
    virtual std::vector<std::string> finish_recording() { return {}; }

    /// The events since the last call.
    virtual std::vector<DisplayEvent> take_events() = 0;

    /// The EGL context that draws. It may be shared with the displays before and after; GL objects then stay
    /// valid for them.
    virtual const std::shared_ptr<Egl>& gl() const = 0;

    /// True if gl() outlives this display; else all GL objects must be destroyed before it.
    virtual bool has_lasting_gl() const { return false; }

    /// The device, its modes and its renderer, for the log.
    virtual std::string description() const = 0;
};

/// The files that an off-screen run writes.
struct Recording {
    std::optional<std::filesystem::path> film;      // MP4: every frame
    std::optional<std::filesystem::path> snapshot;  // PNG: the last frame
};

/// The settings and command-line options for a display.
struct DisplayRequest {
    Settings::Output output;
    Recording recording;
};

/// The properties of a kind of display, known before one is open.
struct DisplayTraits {
    bool has_terminal = true;  // its panels belong to the terminal in front; input devices are read, too
    bool is_awaited = true;    // the player waits for a missing display; else it ends without one
    bool can_wait_for_pictures = false;  // nobody is watching: a frame may be late if it is exact
    ScreenSize expected{.width = 1920, .height = 1080};  // size of the first screen, until one is open
};

/// Opens displays of one kind: the first one, and another one after each loss. Keeps the parts that outlast a
/// single display. A new kind of display needs one such class and a line in display_kinds.cpp.
class DisplayOpener {
  public:
    explicit DisplayOpener(DisplayTraits traits) : traits_(traits) {}

    DisplayOpener(const DisplayOpener&) = delete;
    DisplayOpener& operator=(const DisplayOpener&) = delete;
    DisplayOpener(DisplayOpener&&) = delete;
    DisplayOpener& operator=(DisplayOpener&&) = delete;
    virtual ~DisplayOpener() = default;

    const DisplayTraits& traits() const { return traits_; }

    /// @pre the display before was destroyed
    /// @throws std::runtime_error, std::system_error: there is no display, or it cannot be drawn on
    virtual std::unique_ptr<Display> open() = 0;

  private:
    DisplayTraits traits_;
};

}  // namespace vitrine::player
