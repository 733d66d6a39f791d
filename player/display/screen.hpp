#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace vitrine {

/// Something that became of a screen, for the log.
struct ScreenEvent {
    bool is_trouble = false;
    std::string text;  // "visible 1920x1080 on HDMI-A-1 at 60.00 Hz"
};

/// A place to show pictures: a KMS output, or memory when off screen. One of the two true seams of the
/// player. Thread-bound to the thread that made it, which holds its EGL context current.
class Screen {
  public:
    Screen() = default;
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    Screen(Screen&&) = delete;
    Screen& operator=(Screen&&) = delete;
    virtual ~Screen() = default;

    virtual int width() const = 0;  // px
    virtual int height() const = 0;

    /// Makes the surface current that the next picture is drawn to.
    virtual void begin_frame() = 0;

    /// Shows what was drawn since begin_frame(), meant to appear at `time` since the player's start.
    virtual void present(std::chrono::nanoseconds time) = 0;

    /// To be polled for POLLIN between frames, then dispatch() called; -1: none.
    virtual int event_fd() const = 0;
    virtual void dispatch() = 0;

    /// False while the last present() is still under way and a new begin_frame() would have to wait.
    virtual bool is_ready() const = 0;

    /// False while there is nothing to draw on (no panel): nothing is rendered then.
    virtual bool is_visible() const = 0;

    /// What has become of it since the last call.
    virtual std::vector<ScreenEvent> take_events() = 0;

    /// For the log: what this is, its mode, its renderer.
    virtual std::string description() const = 0;
};

}  // namespace vitrine
