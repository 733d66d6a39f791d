#pragma once

#include "base/settings/settings.hpp"
#include "player/catalogue_follower.hpp"
#include "player/display/screen.hpp"
#include "player/frame_clock.hpp"
#include "player/layout/planner.hpp"
#include "player/playback/source_pool.hpp"
#include "player/rehearsal.hpp"
#include "player/render/renderer.hpp"
#include "player/render/view.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine {

class OffscreenScreen;

/// What only a command line says of a run.
struct PlayOptions {
    std::optional<std::chrono::nanoseconds> duration;  // none: until stopped
    std::optional<std::filesystem::path> film;         // off screen only
    std::optional<std::filesystem::path> snapshot;     // off screen only: the last picture
    std::optional<Rehearsal> rehearsal;                // what happens to the wall of itself
    bool is_realtime = false;  // off screen: pictures at their time, late or not, instead of each exact
};

/// The player put together: the catalogue makes the wall, the wall asks for layouts and sources, and what the
/// wall looks like at each tick of the frame clock is drawn on the screen.
class Player {
  public:
    /// @throws std::runtime_error naming what cannot be opened
    Player(const Settings& settings, const PlayOptions& options);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    /// Until the duration is over, or SIGTERM or SIGINT.
    void run();

  private:
    std::unique_ptr<Screen> make_screen();
    std::unique_ptr<Show> make_show() const;
    std::chrono::nanoseconds now() const;
    void follow(const CatalogueChange& change);
    void tick();
    void tell_of_screen();
    void rehearse(std::chrono::nanoseconds time);
    void follow_screen_size();
    WallStep next_step(std::chrono::nanoseconds time);
    void take_layout();
    void take_layout(Layout layout);
    void ask(const WallPlan& wall);
    void take_source_events(const std::vector<SourceEvent>& events, std::chrono::nanoseconds time);
    void carry_out(const WallStep& step);
    void draw(Frame& frame);
    void tell();
    void finish();

    Settings settings_;
    PlayOptions options_;
    EventLoop loop_;
    EventLoop::Source interrupted_;  // blocked before any thread starts, which else would be killed by them
    EventLoop::Source terminated_;
    OffscreenScreen* offscreen_ = nullptr;  // screen_ where it is one
    bool is_paced_by_pictures_ = false;     // the clock waits for the sources, not they for the clock
    std::unique_ptr<Screen> screen_;
    View view_;
    Vec2 canvas_;  // px
    Renderer renderer_;
    std::unique_ptr<Show> show_;
    WallPlan planned_;         // the plan last asked for
    std::uint64_t asked_ = 0;  // what the planner calls it
    SourcePool sources_;
    std::map<SourceId, std::shared_ptr<const void>>
        uploaded_;  // the sample that the renderer has; shared with it
    Planner planner_;
    CatalogueFollower follower_;
    FrameClock clock_;
    EventLoop::Clock::time_point start_;
    std::size_t items_ = 0;  // on the wall, as last told
    EventLoop::Source tick_;
    EventLoop::Source screen_events_;
    EventLoop::Source told_;  // systemd, every few seconds
};

}  // namespace vitrine
