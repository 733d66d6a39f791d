#pragma once

#include "base/system/event_loop.hpp"
#include "player/content/calendar.hpp"
#include "player/content/panel_hours.hpp"
#include "player/control/cec_standby.hpp"
#include "player/playback/sample.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace vitrine::player {

class Console;
class Display;
class DisplayOpener;
class Egl;
class Renderer;
class Screen;
struct DisplayTraits;

/// Functions that the session calls when its renderer comes and goes.
struct RendererCalls {
    std::function<void(PictureForm)> began;  // gets the form of picture that it draws fastest
    std::function<void()> ends;              // called before the renderer is destroyed
};

/// The display of a player, during the player's whole run. Opens it, and tries again if that fails. Loses it
/// with its graphics card, leaves it to another terminal and takes it back. Owns the renderer, which lasts as
/// long as its GL context. Logs.
class DisplaySession {
  public:
    /// @param loop    outlives this
    /// @param opener  opens the displays that output.screen names
    /// @param state   the state directory, for the note of the screens' size
    DisplaySession(EventLoop& loop, std::unique_ptr<DisplayOpener> opener, std::filesystem::path state,
                   PanelRules rules, RendererCalls calls);
    DisplaySession(const DisplaySession&) = delete;
    DisplaySession& operator=(const DisplaySession&) = delete;
    DisplaySession(DisplaySession&&) = delete;
    DisplaySession& operator=(DisplaySession&&) = delete;
    ~DisplaySession();

    /// Tries to open the display. If a display may come later, a failure is no error: follow_display() tries
    /// again. @throws std::runtime_error if none can come
    void open();

    /// Call at every tick, before screens().
    /// @param rehearsed  a local time that replaces the present one
    /// @param now        since the player's start
    void follow_display(std::optional<std::chrono::local_seconds> rehearsed, std::chrono::nanoseconds now);

    /// The hours of the panels. Touches wake them, and new settings replace their rules.
    PanelHours& hours() { return hours_; }

    /// The screens to draw on. None: there is no panel or no card, another program has it, or the panels are
    /// off at this hour. Lent until the next follow_display().
    std::span<Screen* const> screens() const;

    /// nullptr: there is none, and no screen.
    Renderer* renderer() { return renderer_.get(); }

    /// Call when a source is retired. Does nothing without a renderer.
    void forget_source(SourceId source);

    /// The properties of this kind of display.
    const DisplayTraits& traits() const;

    /// True: the display shows a picture of an earlier run.
    bool has_old_picture() const;

    /// True: another program, or another terminal, has the display, or the panels are off at this hour.
    bool is_away() const;

    /// Card, modes and renderer in words, or the reason why there is no display.
    std::string description() const;

    /// Call on Console::leave_signal and Console::enter_signal.
    void leave_terminal();
    void return_to_terminal();

    /// Call when the run ends in order. The last picture stays if the display can keep it, and the files of
    /// the run are completed. @throws std::runtime_error naming the file
    void finish();

  private:
    void close();
    void make_renderer();
    void drop_renderer();
    void note_screens();
    void follow_hours(std::optional<std::chrono::local_seconds> rehearsed, std::chrono::nanoseconds now);

    EventLoop& loop_;  // outlives this
    std::unique_ptr<DisplayOpener> opener_;
    std::filesystem::path state_;
    PanelHours hours_;
    Calendar calendar_;
    CecStandby television_;
    RendererCalls calls_;
    std::unique_ptr<Console> console_;       // none: off screen
    std::unique_ptr<Display> display_;       // none: no graphics card at present
    std::string complaint_;                  // the last logged reason why there is no display
    std::shared_ptr<Egl> gl_;                // the renderer's context, shared with the display
    std::unique_ptr<Renderer> renderer_;     // none: no display so far, or its context was lost with the card
    EventLoop::Clock::time_point next_try_;  // time of the next try to open the display
    EventLoop::Source events_;               // the display's events
    int noted_side_ = 0;                     // px; the size that the analyzer was told last
};

}  // namespace vitrine::player
