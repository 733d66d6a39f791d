#pragma once

#include "base/system/event_loop.hpp"
#include "player/playback/sample.hpp"
#include "player/scene/frame.hpp"

#include <filesystem>
#include <functional>
#include <memory>
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

/// Calls of the session when its renderer comes and goes.
struct RendererCalls {
    std::function<void(PictureForm)> began;  // with the form of picture that it draws fastest
    std::function<void()> ends;              // all that it has is about to go
};

/// The display of a player, for as long as the player runs: opens it and tries again where that fails, loses
/// it with its graphics card, leaves it to another terminal and takes it back. Has the renderer, which lasts
/// as long as the GL context that it was made in. Logs.
class DisplaySession {
  public:
    /// @param loop    outlives this
    /// @param opener  of the displays that output.screen names
    /// @param state   the state directory, for a note of the screens' size
    DisplaySession(EventLoop& loop, std::unique_ptr<DisplayOpener> opener, std::filesystem::path state,
                   RendererCalls calls);
    DisplaySession(const DisplaySession&) = delete;
    DisplaySession& operator=(const DisplaySession&) = delete;
    DisplaySession(DisplaySession&&) = delete;
    DisplaySession& operator=(DisplaySession&&) = delete;
    ~DisplaySession();

    /// Tries to open the display. Where there may be one later that is not an error: follow_display() tries
    /// again. @throws std::runtime_error where there will be none
    void open();

    /// To be called at every tick, before screens().
    void follow_display();

    /// The screens to draw on; none: no panel, no card, or somebody else has it. Lent until the next call of
    /// follow_display().
    std::span<Screen* const> screens() const;

    /// @pre !screens().empty()
    Renderer& renderer() { return *renderer_; }

    /// For a source that is given up; nothing happens where there is no renderer.
    void forget_source(SourceId source);

    /// The facts about the kind of display.
    const DisplayTraits& traits() const;

    /// True: the display shows a picture of an earlier run.
    bool has_old_picture() const;

    /// True: another program, or another terminal, has the display.
    bool is_away() const;

    /// Card, modes and renderer in words, or why there is no display.
    std::string description() const;

    /// Console::leave_signal and Console::enter_signal came.
    void leave_terminal();
    void return_to_terminal();

    /// The run ends as it should: the last picture stays where the display can do that, and the files that
    /// the run writes are completed. @throws std::runtime_error naming the file
    void finish();

  private:
    void close();
    void make_renderer();
    void drop_renderer();
    void note_screens();

    EventLoop& loop_;  // outlives this
    std::unique_ptr<DisplayOpener> opener_;
    std::filesystem::path state_;
    RendererCalls calls_;
    std::unique_ptr<Console> console_;       // none: off screen
    std::unique_ptr<Display> display_;       // none: no graphics card for now
    std::string complaint_;                  // why there is no display, as last logged
    std::shared_ptr<Egl> gl_;                // the renderer's context, shared with the display
    std::unique_ptr<Renderer> renderer_;     // none: no display so far, or its context went with the card
    EventLoop::Clock::time_point next_try_;  // to open the display
    EventLoop::Source events_;               // the display's events
    int noted_side_ = 0;                     // px, the size of the screens in the note for the analyzer
};

}  // namespace vitrine::player
