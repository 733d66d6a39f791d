#pragma once

#include "player/display/egl.hpp"
#include "player/display/picture.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// A place to show pictures: a panel, or memory when off screen. Thread-bound to the thread that made it,
/// which holds its EGL context current.
class Screen {
  public:
    Screen() = default;
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    Screen(Screen&&) = delete;
    Screen& operator=(Screen&&) = delete;
    virtual ~Screen() = default;

    /// Of the connector: "HDMI-A-1".
    virtual const std::string& name() const = 0;

    virtual int width() const = 0;  // px
    virtual int height() const = 0;

    /// Pictures a second that it can take; 0: as many as come.
    virtual double refresh() const { return 0; }

    /// Pictures that have reached it so far: flips that the card has told of, not those asked for.
    virtual std::uint64_t flips() const = 0;

    /// What it shows now, read back from where it is shown from; nothing before the first picture.
    /// @throws std::runtime_error where it cannot be read
    virtual std::optional<Picture> shown() = 0;

    /// False while the last present() is still under way and a new begin_frame() would have to wait.
    virtual bool is_ready() const = 0;

    /// Whether the picture presented last is not to be seen and will not be: the next one is to be drawn,
    /// also where it is the same.
    virtual bool wants_picture() const = 0;

    /// Makes the surface current that the next picture is drawn to.
    virtual void begin_frame() = 0;

    /// Shows what was drawn since begin_frame(), meant to appear at `time` since the player's start.
    virtual void present(std::chrono::nanoseconds time) = 0;
};

/// Something that became of a display, for the log.
struct DisplayEvent {
    bool is_trouble = false;
    std::string text;  // "visible 1920x1080 on HDMI-A-1 at 60.00 Hz"
};

/// All that there is to show on: a graphics card with its panels, or memory. Has one EGL context for all its
/// screens, which is current for as long as it lives. One of the two true seams of the player.
class Display {
  public:
    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    Display(Display&&) = delete;
    Display& operator=(Display&&) = delete;
    virtual ~Display() = default;

    /// Those to draw on now, always in the same order; none: no panel, or another program has the card.
    /// Lent until the next call.
    virtual std::span<Screen* const> screens() = 0;

    /// To be polled for POLLIN between frames, then dispatch() called; -1: none.
    virtual int event_fd() const = 0;
    virtual void dispatch() = 0;

    /// Nothing will ever be shown on it again: the card was pulled out. All that GL made is to be ended,
    /// unless gl() is kept for another display, then this; another may be made.
    virtual bool is_gone() const = 0;

    /// Whether another program, or another terminal, has the card: nothing is shown on purpose.
    virtual bool is_away() const { return false; }

    /// Leaves the card to other programs until take_back().
    virtual void leave() = 0;
    virtual void take_back() = 0;

    /// Whether it shows a picture of an earlier run, which stays until one is presented.
    virtual bool has_old_picture() const { return false; }

    /// The program ends in order: what is shown stays for the next one. False: it cannot.
    virtual bool keep_picture() { return false; }

    /// What has become of it since the last call.
    virtual std::vector<DisplayEvent> take_events() = 0;

    /// What draws. Where it is shared with the displays before and after, what GL has made stays good for
    /// them.
    virtual const std::shared_ptr<Egl>& gl() const = 0;

    /// For the log: what this is, its modes, its renderer.
    virtual std::string description() const = 0;
};

}  // namespace vitrine::player
