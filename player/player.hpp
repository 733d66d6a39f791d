#pragma once

#include "base/settings/settings.hpp"
#include "base/system/event_loop.hpp"
#include "player/frame_clock.hpp"
#include "player/input/rehearsal.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine::player {

class DisplaySession;
class PlayerService;
class SourcePool;
class Stages;
class VisibleFiles;
class InputDevices;
class WallPicture;
class WallSound;
struct PlayerActions;
struct PlayerView;

/// The part of a run that only the command line says.
struct PlayOptions {
    std::optional<std::chrono::nanoseconds> duration;  // none: until stopped
    std::optional<std::filesystem::path> film;         // off screen only
    std::optional<std::filesystem::path> snapshot;     // off screen only: the last picture
    std::optional<std::filesystem::path> tapestry;     // a directory: shown in place of the wall
    std::optional<Rehearsal> rehearsal;                // events that need neither files nor a visitor
    std::function<Settings()> read_settings;           // again; empty: the settings stay as they are
    bool is_realtime = false;  // off screen: pictures at their time, late or not, instead of each exact
};

/// The player put together: VisibleFiles says which files there are, the Stages make walls of them, and at
/// each tick of the frame clock a picture of every wall is drawn on the screens of the DisplaySession.
/// Screens and whole graphics cards come and go meanwhile; without them the player waits. Logs.
class Player {
  public:
    /// @throws std::runtime_error naming what cannot be opened; a missing graphics card is awaited
    Player(const Settings& settings, const PlayOptions& options);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;
    Player(Player&&) = delete;
    Player& operator=(Player&&) = delete;

    /// Until the duration is over, or SIGTERM or SIGINT.
    void run();

  private:
    std::vector<EventLoop::Source> watch_signals();
    void make_display();
    void make_sources();
    PlayerView view() const;
    PlayerActions actions();
    void begin_stages();
    bool is_paced_by_pictures() const;
    std::chrono::nanoseconds now() const;
    void give_files();
    void tick();
    void handle_input(std::chrono::nanoseconds time);
    void look_at_files(std::chrono::nanoseconds time);
    void play_sound(std::chrono::nanoseconds time);
    void take_wall_picture(std::chrono::nanoseconds time);
    void reload();
    void finish();

    Settings settings_;
    PlayOptions options_;
    EventLoop loop_;
    std::vector<EventLoop::Source>
        signals_;  // blocked before any thread starts, or they would end the player
    std::unique_ptr<DisplaySession> display_;
    std::unique_ptr<VisibleFiles> files_;
    std::unique_ptr<SourcePool> sources_;
    std::unique_ptr<Stages> stages_;
    std::unique_ptr<WallSound> sound_;           // none: there is no device for it
    std::unique_ptr<WallPicture> wall_picture_;  // none: there is no status page
    std::unique_ptr<PlayerService> service_;
    std::unique_ptr<InputDevices> input_devices_;
    FrameClock clock_;
    EventLoop::Clock::time_point start_;
    EventLoop::Source tick_;
};

}  // namespace vitrine::player
