#pragma once

#include "player/scene/acts/act_fade.hpp"
#include "player/scene/acts/followed_lifted.hpp"
#include "player/scene/acts/followed_sources.hpp"
#include "player/scene/acts/lifted_json.hpp"
#include "player/scene/acts/noted_touches.hpp"
#include "player/scene/acts/wall_act.hpp"
#include "player/scene/folders/standing_names.hpp"
#include "player/scene/show.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The state of a box beside what the leader shows.
struct FollowedState {
    std::optional<ActName> shown;        // the act that is drawn; none: none yet
    std::optional<ActName> prepared;     // the preparation whose shots are all there
    std::set<std::string> lacking = {};  // paths of shots that the box has not got, or not yet
    std::set<std::string> wanted = {};   // the files of these shots in the store

    bool operator==(const FollowedState&) const = default;
};

/// The wall of a box that follows: it draws the leader's acts at shared time, and decides nothing. Without
/// news it goes on with the last act, whose films play in loops.
///
/// A new act is taken once its shots are there, or some seconds later without those that are not; until then
/// the last act is shown. If the new act does not begin with the wall that is shown, it fades in.
class FollowedWall final : public Show {
  public:
    /// @param last_source  the sources are numbered from here on
    FollowedWall(const Canvas& canvas, SourceId last_source) : canvas_(canvas), sources_(last_source) {}

    void set_canvas(const Canvas& canvas) override { canvas_ = canvas; }

    using Show::set_catalogue;

    void set_catalogue(const RecordList& /*records*/, const ShowHints& /*hints*/) override {}

    void set_layout(const Layout& /*layout*/) override {}

    void source_ready(SourceId source) override { sources_.set_ready(source); }

    /// A shot that is not there is asked for again every few seconds.
    void source_failed(SourceId source, std::chrono::nanoseconds now) override {
        sources_.set_failed(source, now);
    }

    WallStep step(std::chrono::nanoseconds now) override;

    std::vector<SlotShot> standing() const override;

    FollowedWall* followed() override { return this; }

    /// Sets the clock that all boxes share. @param epoch  shared time, since 1970, at this wall's time 0
    /// @param is_right  others keep the clock right; the first act waits some seconds for that
    void set_clock(std::chrono::nanoseconds epoch, bool is_right) {
        epoch_ = epoch;
        is_clock_right_ = is_right;
    }

    /// Takes an act from now on. Ignores one that is older than the last one.
    void take(const WallAct& act);

    /// Opens the shots of an act that is about to come.
    void prepare(const WallAct& coming);

    /// Draws what hands hold above the wall, as the leader has drawn it.
    void take_lifted(ToldHands told);

    /// The tapestry in place of the wall, in this wall's time. nullptr: none.
    const TapestryMoment* tapestry() const { return shown_ ? lifted_.tapestry(now_) : nullptr; }

    /// True: nothing moves now and no act waits, so the clock may jump.
    bool is_between_acts() const;

    FollowedState state() const;

    /// The touches of visitors, for the leader.
    NotedTouches& touches() { return touches_; }

    /// The act that is drawn; nullptr: none yet.
    const WallAct* shown() const { return shown_ ? &*shown_ : nullptr; }

  private:
    void take_waiting();
    Frame next_frame();

    Canvas canvas_;
    FollowedSources sources_;
    std::chrono::nanoseconds epoch_{0};
    bool is_clock_right_ = false;
    std::chrono::nanoseconds now_{0};
    std::optional<WallAct> shown_;
    std::vector<Box> bezels_;         // of the act that is shown, canvas px
    std::optional<WallAct> waiting_;  // will be shown once its shots are there
    std::chrono::nanoseconds waiting_since_{0};
    std::optional<WallAct> prepared_;
    ActFade fade_;
    StandingNames names_;
    NotedTouches touches_;
    FollowedLifted lifted_;
};

}  // namespace vitrine::player
