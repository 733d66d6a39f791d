#pragma once

#include "base/settings/settings.hpp"
#include "base/system/event_loop.hpp"
#include "player/content/catalogue_follower.hpp"
#include "player/content/crash_note.hpp"
#include "player/content/hours_follower.hpp"
#include "player/display/console.hpp"
#include "player/display/display.hpp"
#include "player/frame_clock.hpp"
#include "player/input/input_devices.hpp"
#include "player/playback/source_pool.hpp"
#include "player/playback/wall_sound.hpp"
#include "player/player_service.hpp"
#include "player/rehearsal.hpp"
#include "player/render/renderer.hpp"
#include "player/stage/stage.hpp"
#include "player/stage/wall_picture.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// What only a command line says of a run.
struct PlayOptions {
    std::optional<std::chrono::nanoseconds> duration;  // none: until stopped
    std::optional<std::filesystem::path> film;         // off screen only
    std::optional<std::filesystem::path> snapshot;     // off screen only: the last picture
    std::optional<std::filesystem::path> tapestry;     // a directory: shown in place of the wall
    std::optional<Rehearsal> rehearsal;                // what happens to the wall of itself
    std::function<Settings()> read_settings;           // again; empty: they stay as they are
    bool is_realtime = false;  // off screen: pictures at their time, late or not, instead of each exact
};

/// The player put together: the catalogue makes the walls, the walls ask for layouts and sources, and what a
/// wall looks like at each tick of the frame clock is drawn on its screens. Panels and whole graphics cards
/// come and go meanwhile; without them it waits.
class Player {
  public:
    /// @throws std::runtime_error naming what cannot be opened; that there is no graphics card is awaited
    Player(const Settings& settings, const PlayOptions& options);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Until the duration is over, or SIGTERM or SIGINT.
    void run();

  private:
    void open_display();
    void make_renderer();
    void drop_renderer();
    void make_stages();
    void expect_screen();
    void note_screens();
    std::chrono::nanoseconds now() const;
    void follow(const CatalogueChange& change);
    void give_catalogue();
    void follow_hours(std::chrono::nanoseconds time);
    void rehearse(std::chrono::nanoseconds time);
    void take(const Screen& screen, InputEvent event);
    void tick();
    void take_wall_picture(std::chrono::nanoseconds time);
    void hear(std::chrono::nanoseconds time);
    bool is_time_to_draw(std::chrono::nanoseconds time);
    void follow_display(std::chrono::nanoseconds time);
    void close_display();
    void give_screens(std::chrono::nanoseconds time);
    void leave_terminal();
    void come_to_terminal();
    void hand_out(const std::vector<SourceEvent>& events);
    void tell_items();
    void tell();
    void reload();
    void reload_or_tell();
    void finish();

    Settings settings_;
    PlayOptions options_;
    EventLoop loop_;
    EventLoop::Source interrupted_;  // blocked before any thread starts, which else would be killed by them
    EventLoop::Source terminated_;
    EventLoop::Source reloaded_;  // SIGHUP: the settings are to be read again
    EventLoop::Source left_;      // the terminal: another one is to be in front
    EventLoop::Source entered_;   // ours is in front again
    int noted_side_ = 0;          // px, as the analyzer was told last
    std::unique_ptr<DisplayOpener> opener_;
    bool is_paced_by_pictures_ = false;  // the clock waits for the sources, not they for the clock
    std::unique_ptr<Console> console_;   // none: off screen
    std::unique_ptr<Display> display_;   // none: no graphics card for now
    std::string complaint_;              // why there is none, as last told
    std::shared_ptr<Egl> gl_;            // of the renderer, shared with the display
    std::optional<Renderer> renderer_;   // where there is a display, or what draws outlasted one
    CrashNote crash_note_;               // before the sources, whose files it is told of
    SourcePool sources_;
    std::optional<WallSound> sound_;               // none: nothing is ever heard
    std::map<std::string, std::size_t> stage_of_;  // output -> stages_; the others show the first
    std::vector<std::unique_ptr<Stage>> stages_;
    std::optional<Operation> operation_;
    std::optional<WallPicture> wall_picture_;  // none: not wanted
    HoursFollower hours_;
    std::chrono::nanoseconds next_look_{0};  // at the opening hours
    CatalogueFollower follower_;
    FrameClock clock_;
    EventLoop::Clock::time_point start_;
    EventLoop::Clock::time_point next_try_;     // to open a display
    std::map<std::string, std::size_t> items_;  // on the wall of each folder, as last told
    Visitors visitors_;
    EventLoop::Source tick_;
    EventLoop::Source display_events_;
    EventLoop::Source told_;   // systemd, every few seconds
    EventLoop::Source noted_;  // what plays, likewise
};

}  // namespace vitrine::player
