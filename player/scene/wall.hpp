#pragma once

#include "player/scene/change_pace.hpp"
#include "player/scene/repeated_shots.hpp"
#include "player/scene/show.hpp"
#include "player/scene/touched_film.hpp"
#include "player/scene/wall_change.hpp"
#include "player/scene/wall_entries.hpp"
#include "player/scene/wall_sources.hpp"
#include "player/scene/wall_touch.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct WallSettings {
    SlotSettings slots;
    TransitionStyle transition;
    bool nests = false;          // the slots hold the entries of a level of the folder tree
    bool is_calm = false;        // nothing moves, and changes are rare
    bool comes_at_once = false;  // the first wall is shown when all its sources are ready, without a fade
    bool photos_drift = false;   // photos move slowly inside their cells
    std::chrono::nanoseconds patience = std::chrono::seconds(10);  // time to wait for a late source
    EditRules touch;                                               // rules by which a finger moves shots
    std::chrono::nanoseconds idle = std::chrono::seconds(30);      // then a tapped shot returns to its place
    std::chrono::nanoseconds hint{0};        // alone so long, shots show that they can be touched; 0: never
    std::chrono::nanoseconds lead{0};        // time from the decision of a change to its begin, so that other
                                             // boxes learn of it; the first wall then comes as a whole
    std::chrono::nanoseconds touch_lead{0};  // the same for changes by touch
};

/// The parts from which a wall draws. Lent until the wall's next call.
struct WallParts {
    std::span<const PlacedShot> shown;        // without the shots that fade in
    const Canvas& canvas;                     // of `shown`
    const std::optional<WallChange>& change;  // none: the wall stands
    const LiftedShots& lifted;
    const std::optional<FilmMoment>&
        film;  // above a photo that was tapped; none: no film of a photo is needed
};

/// The wall on the screen over time. WallEntries decides which shots are shown. The wall requests a layout
/// and the sources. When the sources are ready and the leaving shot has had its time, it moves and fades from
/// the old wall, which continues to play, to the new one. Then it retires the sources that are not needed any
/// more. There is one change at a time (WallChange). If the slots change again before its fade has started,
/// the change is replaced. The first wall waits for its first source only; its shots fade in over the idle
/// picture, each when it is ready.
///
/// A canvas of more displays than shots has copies of shots, so that each display shows one.
///
/// Two changes never begin so soon after one another that bright and dark pictures would flash. On a calm
/// wall nothing moves and changes begin at least calm_spacing apart; its first wall comes as a whole.
///
/// A change moves the shots that stay as little as possible. If that leaves much more of the canvas empty
/// than a completely new layout, the new layout is used. So it is where most shots are new.
class Wall final : public Show {
  public:
    Wall(const Canvas& canvas, const WallSettings& settings);

    /// Call when the screen's mode has changed: the same shots are laid out again.
    void set_canvas(const Canvas& canvas) override;

    using Show::set_catalogue;
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    /// Lifts, moves, enlarges or dismisses the touched shot (WallTouch). No other change starts until the
    /// wall has settled. A folder moves as a whole. Shots of a calm wall are not
    /// dragged.
    void handle_gesture(const Gesture& gesture) override;

    std::optional<SeenShot> shot_at(Vec2 point) const override;

    /// Takes the layout of a plan of this wall, in the order of the plan's items. Ignores the layout of an
    /// outdated plan. The first wall also takes layouts that are not final, so that its sources get ready
    /// while a better layout is made.
    /// @pre one placement for each item of the plan
    void set_layout(const Layout& layout) override;

    void source_ready(SourceId source) override {
        sources_.set_ready(source);
        touched_film_.source_ready(source);
    }

    /// Replaces the source's file by another. Its shots stay on the wall until the others are ready.
    void source_failed(SourceId source, std::chrono::nanoseconds now) override;

    /// An arrangement is taken once the wall is left alone. Nothing stays large.
    void set_controls(const ShowControls& controls) override;

    /// @param now  since the player's start; never goes back
    WallStep step(std::chrono::nanoseconds now) override;

    ChangePace* pace() override { return &pace_; }

    std::vector<SlotShot> standing() const override;

    std::set<std::string> avoided_files() const override { return slots_.avoided_files(); }

    /// True while a visitor touches the wall, and until all is back in its place.
    bool is_touched() const { return touch_.is_active() || (change_ && change_->is_by_touch); }

    WallParts parts() const {
        return {shown_, shown_canvas_, change_, touch_.lifted(), touched_film_.moment()};
    }

    /// The shots on the wall, without those that fade in.
    std::span<const PlacedShot> shown() const { return shown_; }

  private:
    void end_change(std::chrono::nanoseconds now);
    void follow_touch(std::chrono::nanoseconds now, WallStep& step);
    std::optional<WallPlan> follow_slots();
    void wait_for_sources(std::chrono::nanoseconds now);

    WallSettings settings_;
    Canvas canvas_;
    WallEntries slots_;
    RepeatedShots copies_;
    WallTouch touch_;
    TouchedFilm touched_film_;
    WallSources sources_;
    std::vector<PlacedShot> shown_;
    Canvas shown_canvas_;  // the canvas of shown_'s layout
    std::optional<WallChange> change_;
    bool must_plan_ = false;  // the canvas is new, or an arrangement is to be taken
    bool is_held_ = false;    // no change begins
    double usual_waste_ = 1;  // waste of the last new layout, as a share of the canvas
    std::uint64_t generation_ = 0;
    ChangePace pace_;
};

/// True while a change of the wall is seen.
inline bool is_in_change(const Wall& wall) {
    const std::optional<WallChange>& change = wall.parts().change;
    return change && change->is_fading();
}

}  // namespace vitrine::player
