#pragma once

#include "base/geometry/vec2.hpp"
#include "player/display/picture.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace vitrine::player {

/// A place to show frames: a panel, or memory when off screen. Thread-bound to the thread that made it, on
/// which its EGL context is current.
class Screen {
  public:
    Screen() = default;

    explicit Screen(Vec2 millimetres) : millimetres_(millimetres) {}

    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;
    Screen(Screen&&) = delete;
    Screen& operator=(Screen&&) = delete;
    virtual ~Screen() = default;

    /// The connector's name: "HDMI-A-1".
    virtual const std::string& name() const = 0;

    virtual int width() const = 0;  // px
    virtual int height() const = 0;

    /// The panel's sides as it tells them, mm; 0: it tells none. Along width() and height().
    Vec2 millimetres() const { return millimetres_; }

    /// Frames a second that it can show; 0: no limit.
    virtual double refresh() const { return 0; }

    /// The number of frames that have reached it so far: flips that the card has reported, not those
    /// requested.
    virtual std::uint64_t flips() const = 0;

    /// The picture on the screen, read back from the shown buffer. None: no frame was shown yet.
    /// @throws std::runtime_error if it cannot be read
    virtual std::optional<CardPicture> shown() = 0;

    /// False while the last present() is still under way and a new begin_frame() would have to wait.
    virtual bool is_ready() const = 0;

    /// True if the last presented frame is not on the screen and will not be. The next frame must then be
    /// drawn, even if it is equal.
    virtual bool wants_picture() const = 0;

    /// Turns the panel off until the next present(). Call it again as long as the panel shall be off: another
    /// program may have lit it.
    virtual void turn_off() {}

    /// Makes the surface of the next frame current.
    virtual void begin_frame() = 0;

    /// Shows the frame drawn since begin_frame(). @param time  when it should appear, since the player's
    /// start
    virtual void present(std::chrono::nanoseconds time) = 0;

  private:
    Vec2 millimetres_;
};

}  // namespace vitrine::player
