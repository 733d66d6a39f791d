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
class ReaderHost;
class WallLink;
class WallPicture;
class WallSound;
struct PlayerActions;
struct PlayerView;

/// The options of a run that are not settings.
struct PlayOptions {
    std::optional<std::chrono::nanoseconds> duration;  // none: until stopped
    std::optional<std::filesystem::path> film;         // off screen only
    std::optional<std::filesystem::path> snapshot;     // off screen only: the last picture
    std::optional<std::filesystem::path> tapestry;  // a directory; its tapestry is shown in place of the wall
    std::optional<Rehearsal> rehearsal;             // events for a run without new files or visitors
    std::function<Settings()> read_settings;        // reads the settings again; empty: they stay as they are
    std::shared_ptr<ReaderHost> readers;            // decodes the media folder's files; none: the player does
    bool is_realtime = false;  // off screen: pictures at their time, even if late; else each picture exact
};

/// The whole player: VisibleFiles lists the files, the Stages make walls of them, and at each tick of the
/// frame clock a frame of every wall is drawn on the screens of the DisplaySession. Screens and graphics
/// cards come and go meanwhile; without them the player waits. Logs.
class Player {
  public:
    /// @throws std::runtime_error naming what cannot be opened. A missing graphics card is no error: the
    /// player waits for it
    Player(const Settings& settings, const PlayOptions& options);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;
    Player(Player&&) = delete;
    Player& operator=(Player&&) = delete;

    /// Runs until the duration is over, or SIGTERM or SIGINT comes.
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
    void tick();
    void rest(std::chrono::nanoseconds time);
    void handle_input(std::chrono::nanoseconds time);
    void look_at_files(std::chrono::nanoseconds time);
    void play_sound(std::chrono::nanoseconds time);
    void take_wall_picture(std::chrono::nanoseconds time);
    void reload();
    void renew_stages(std::chrono::nanoseconds time);
    void finish();

    Settings settings_;
    PlayOptions options_;
    EventLoop loop_;
    std::vector<EventLoop::Source>
        signals_;  // blocked before any thread starts; otherwise they would end the player
    std::unique_ptr<DisplaySession> display_;
    std::unique_ptr<VisibleFiles> files_;
    std::unique_ptr<SourcePool> sources_;
    std::unique_ptr<Stages> stages_;
    std::unique_ptr<WallSound> sound_;           // none: no sound device is set
    std::unique_ptr<WallPicture> wall_picture_;  // none: there is no status page
    std::unique_ptr<PlayerService> service_;
    std::unique_ptr<InputDevices> input_devices_;
    FrameClock clock_;
    std::unique_ptr<WallLink> wall_;  // never null
    EventLoop::Source tick_;
};

}  // namespace vitrine::player
