#pragma once

#include "base/settings/settings.hpp"
#include "base/system/event_loop.hpp"
#include "base/wall/line_caller.hpp"
#include "base/wall/wall_message.hpp"
#include "player/control/player_report.hpp"
#include "player/scene/acts/box_talk.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/wall_link/fetch_fault.hpp"
#include "player/wall_link/shared_clock.hpp"
#include "player/wall_link/wanted_files.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

class Screen;
class Show;
class Stage;
class Stages;

/// A box's part in a wall of several boxes: it talks to the others by way of vitrine-link, which alone speaks
/// to the network, and keeps the time that all share. For a box that shows its wall alone it only counts the
/// time. Logs.
class WallLink {
  public:
    /// @param loop, settings  outlive this
    WallLink(EventLoop& loop, const Settings& settings);

    /// False: the wall is this box's alone.
    bool is_shared() const { return talk_ != nullptr; }

    /// The outputs of the other boxes, as they are at any time.
    std::shared_ptr<const OtherOutputs> others() const { return others_; }

    /// Call when the run begins.
    void begin() { clock_.begin(); }

    /// Call when the stages' shows have been replaced: the other boxes follow the new one.
    void begin_anew() {
        if (talk_) talk_->begin_anew();
    }

    /// Call at every tick: looks at the clocks. They may jump while nothing moves on the wall.
    void follow_clocks(Show& show);

    /// The time since the player's start.
    std::chrono::nanoseconds now() const { return clock_.now(); }

    /// The moment of the steady clock at which now() is 0, as far as now() goes on as it does.
    EventLoop::Clock::time_point start() const { return clock_.start(); }

    /// Tells the other boxes if a touch has lit the panels of this one.
    void set_awake(bool is_awake) { is_awake_ = is_awake; }

    /// Call before each frame: the first stage hears what the others have said, and how they were touched.
    /// @param screens  of this box; none: if it follows, it hears of the wall once it has one
    /// @param now      of the frame
    void direct(Stages& stages, std::span<Screen* const> screens, std::chrono::nanoseconds now);

    /// Call after each frame: says what there is to say.
    void speak(Show& show, std::chrono::nanoseconds now);

    /// None: the wall is this box's alone.
    std::optional<WallReport> report() const;

  private:
    void call(EventLoop& loop);
    void hear(const std::string& line);
    void complain(const std::string& why);
    void follow_others();
    void touch(Stage& stage, const BoxMoment& here);
    std::vector<BoxOutput> outputs_of(std::span<Screen* const> screens) const;
    BoxMoment moment(std::chrono::nanoseconds now) const;

    const Settings& settings_;  // outlive this
    SharedClock clock_;
    FetchFault fetch_fault_;
    WantedFiles wanted_;
    std::shared_ptr<OtherOutputs> others_;  // shared with the stage that reads it
    std::unique_ptr<BoxTalk> talk_;         // none: the wall is this box's alone
    std::vector<WallMessage> heard_;
    std::vector<BoxOutput> outputs_;
    bool has_guides_ = false;
    bool is_awake_ = false;
    std::string complaint_;  // the last one
    std::string link_says_ = "vitrine-link is not there";
    bool is_linked_ = false;
    std::optional<LineCaller> caller_;
};

}  // namespace vitrine::player
