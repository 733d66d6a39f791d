#pragma once

#include "player/scene/acts/awaited_sources.hpp"
#include "player/scene/acts/wall_act.hpp"
#include "player/scene/lifted_shots.hpp"
#include "player/scene/show.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A show around another one, to which it passes all on. What it does besides is in classes that override it.
class ForwardingShow : public Show {
  public:
    using Show::set_catalogue;

    void set_canvas(const Canvas& canvas) override { inner().set_canvas(canvas); }

    void set_catalogue(const RecordList& records, const ShowHints& hints) override {
        inner().set_catalogue(records, hints);
    }

    void set_layout(const Layout& layout) override { inner().set_layout(layout); }

    void source_ready(SourceId source) override { inner().source_ready(source); }

    void source_failed(SourceId source, std::chrono::nanoseconds now) override {
        inner().source_failed(source, now);
    }

    void handle_gesture(const Gesture& gesture) override { inner().handle_gesture(gesture); }

    std::optional<SeenShot> shot_at(Vec2 point) const override { return inner().shot_at(point); }

    void set_controls(const ShowControls& controls) override { inner().set_controls(controls); }

    WallStep step(std::chrono::nanoseconds now) override { return inner().step(now); }

    ChangePace* pace() override { return inner().pace(); }

    std::string opened_folder() const override { return inner().opened_folder(); }

    std::vector<SlotShot> standing() const override { return inner().standing(); }

    std::set<std::string> avoided_files() const override { return inner().avoided_files(); }

  private:
    virtual Show& inner() = 0;
    virtual const Show& inner() const = 0;
};

/// The messages that the other boxes must get.
struct LedNews {
    std::optional<WallAct> act;          // the newest; its generation counts the acts
    std::optional<WallAct> preparation;  // the shots that come next; its generation counts the preparations
    LiftedMoment lifted = {};            // what hands hold above the wall now
    std::optional<TapestryMoment> tapestry = {};  // in place of the wall, in the time of step()
    std::chrono::nanoseconds now{0};              // the show's time
};

/// The facts that the other boxes tell: what they have, and what they lack.
struct LedOthers {
    std::optional<std::uint64_t> ready;  // they have all preparations up to this number; none: nobody is
                                         // waited for
    bool needs_act = false;              // the act under way is wanted once more, with a number of its own
};

/// The show of the box that leads a wall of several boxes. It makes acts of what it shows, from which the
/// others draw the same. Before that it tells which shots come, and waits a while until they have them, too.
class LedShow : public ForwardingShow {
  public:
    LedShow* led() override { return this; }

    using Show::set_catalogue;

    /// Tells a preparation again if the store has got one of its shots.
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    void set_controls(const ShowControls& controls) override;

    void source_ready(SourceId source) override;
    WallStep step(std::chrono::nanoseconds now) override;

    /// Tells which preparations the other boxes have.
    void heed(const LedOthers& others);

    /// The news since the last call.
    LedNews take_news();

    /// Sets the parts that outputs show of the canvas, and of the one before, which may still be seen.
    /// @param parts  the newest first
    void set_parts(std::vector<ActParts> parts);

    /// Sets the words that all boxes draw over the wall.
    void set_words(WallWords words) { words_ = std::move(words); }

    /// Tells of the tapestry that is shown in place of the wall. @param seen  none: the wall is shown
    void tell_tapestry(std::optional<TapestryMoment> seen) { tapestry_ = std::move(seen); }

    /// True while a change is seen: the wall's clock must not jump.
    virtual bool is_changing() const = 0;

  protected:
    std::chrono::nanoseconds now() const { return now_; }

    /// Tells of the shots that come, so that the other boxes have them in time.
    void prepare(const std::vector<PlacedShot>& shots, const Canvas& canvas, const CellStyle& cells);

    /// Lets the next make_news() make an act.
    void want_act() { wants_act_ = true; }

    bool wants_act() const { return wants_act_; }

    /// Tells an act, to which it gives its number and the parts of outputs. The first act has shots: without
    /// one, the other boxes go on with the wall of the leader's last run.
    void tell(WallAct act);

  private:
    /// Prepares shots and tells acts, once a step.
    virtual void make_news() = 0;

    /// Tells what hands do above the wall now.
    virtual LiftedMoment lifted() const = 0;

    /// The time of the wall that is seen.
    virtual std::chrono::nanoseconds local_time() const { return now_; }

    std::vector<ActParts> parts_;  // the newest first
    WallWords words_;
    bool is_paused_ = false;
    std::chrono::nanoseconds now_{0};
    AwaitedSources awaited_;
    WallAct prepared_;                    // the last preparation
    std::optional<WallAct> preparation_;  // as long as it is news
    bool wants_act_ = false;
    std::uint64_t acts_ = 0;
    std::optional<WallAct> act_;
    std::optional<TapestryMoment> tapestry_;
};

}  // namespace vitrine::player
