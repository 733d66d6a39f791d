#pragma once

#include "player/scene/lifted_shot.hpp"
#include "player/scene/touched_film.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// Light of a place whose shot is lifted, and of the wall behind a shot that is as large as the screen.
constexpr double waiting_light = 0.35;

enum class LiftedState {
    held,       // under a finger that drags
    large,      // under a finger that rests
    whole,      // as large as the screen
    let_go,     // dropped; waits for its place
    beckoning,  // stays bright while the others are dim, to show that it can be touched
    returning,  // on the way to its place on the wall
    gone,       // flicked out; its return is offered in its place
    dismissed,  // and that time is over
};

/// A number that goes from one value to another in time.
struct Fading {
    double from = 1;
    double to = 1;
    std::chrono::nanoseconds began{0};
    std::chrono::nanoseconds duration{0};

    double at(std::chrono::nanoseconds now) const;
};

struct Lifted {
    LiftedShot picture;
    LiftedState state = LiftedState::held;
    std::uint64_t touch = 0;            // of the hand that has it
    std::chrono::nanoseconds since{0};  // of the state
    Fading seat = {};                   // opacity of the place that it leaves, above the others' cells
};

/// The lifted shots as they are seen at one moment.
struct LiftedMoment {
    struct Shot {
        SourceId source = 0;
        LiftedState state = LiftedState::held;
        LiftedPose pose;
        double full_scale = 0;  // the scale of its whole picture, which it comes to; 0: only its cell is seen
        double seat = 1;        // opacity of the place that it leaves

        bool operator==(const Shot&) const = default;
    };

    std::vector<Shot> shots;
    double filler_light = usual_filler_light;
    std::optional<FilmMoment> film = {};  // of a photo that was tapped
    std::optional<double> view = {};      // left edge of a panning wall's view that a finger moves, ribbon px

    /// True if the wall looks as if nobody had touched it.
    bool is_nothing() const { return shots.empty() && filler_light == usual_filler_light && !film && !view; }

    bool operator==(const LiftedMoment&) const = default;
};

/// The shots that are lifted off a wall, each at most once.
class LiftedShots {
  public:
    /// Lifts a shot, or takes it again. nullptr: it is in another hand.
    Lifted* lift(const PlacedShot& placed, std::uint64_t touch, LiftedState state,
                 std::chrono::nanoseconds now);

    /// Lets a shot beckon: the others become dim for a moment. It covers nothing of them.
    void beckon(const PlacedShot& placed, std::chrono::nanoseconds now);

    /// Ends the beckoning of shots whose moment is over.
    void end_beckoning(std::chrono::nanoseconds now);

    std::map<SourceId, Lifted>& all() { return all_; }

    const std::map<SourceId, Lifted>& all() const { return all_; }

    /// nullptr: the shot is not lifted.
    Lifted* find(SourceId source);
    const Lifted* find(SourceId source) const;

    /// The shot in the hand of a touch. nullptr: none.
    Lifted* of_touch(std::uint64_t touch);

    /// True if a finger holds or drags a shot.
    bool is_held() const;

    /// True if a shot is lifted, and its time is not over.
    bool is_active() const;

    /// True: the shot is not in its place. One that has been flicked out is touched there to have it back.
    bool is_away(SourceId source) const;

    /// The shot that is seen above the wall at a canvas point. nullptr: none.
    const PlacedShot* shot_at(Vec2 point, std::chrono::nanoseconds now) const;

    /// Filler becomes bright while hands move shots, and dark again afterwards: it moves, and a dark patch
    /// that moves is seen.
    void light_filler(std::chrono::nanoseconds now);

    LiftedMoment moment(std::chrono::nanoseconds now) const;

    /// Lifts the shots that were lifted off the same wall elsewhere, as they were seen there.
    /// @param wall  the shots that are not lifted yet are lifted off this
    void show(const LiftedMoment& seen, std::span<const PlacedShot> wall, std::chrono::nanoseconds now);

    /// Draws the shots above the wall in a frame, and dims what waits. Cells of the wall that lie above the
    /// others come after them. Where all shots are in hands, the idle picture is behind them.
    void draw(Frame& frame) const;

  private:
    void let_idle_come(Frame& frame) const;
    void draw_bare(Frame& frame, double dims) const;

    std::map<SourceId, Lifted> all_;
    Fading filler_light_{.from = usual_filler_light, .to = usual_filler_light};
};

}  // namespace vitrine::player
