#pragma once

#include "player/input/gesture.hpp"
#include "player/input/touch_hint.hpp"
#include "player/layout/edit/wall_way.hpp"
#include "player/scene/lifted_shots.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The rules of touches on a wall.
struct TouchRules {
    EditRules edits;
    CellStyle cells;
    std::chrono::nanoseconds idle = std::chrono::seconds(30);  // then what was enlarged returns
    std::chrono::nanoseconds hint{0};  // alone so long, shots show that they can be touched; 0: never
    bool is_calm = false;              // nothing moves: a shot fades in large
};

/// The wall that is touched, as it is now.
struct TouchedWall {
    std::span<const PlacedShot> shots;  // with cells
    Canvas canvas;                      // px
    bool is_changing = false;           // without a touch, now or soon
    Vec2 origin = {};                   // of the canvas, in the px of shots and gestures
};

/// A change of the wall that touches ask for.
struct TouchedWay {
    WayRequest request;
    std::chrono::nanoseconds duration{0};
};

/// The needs that follow from touches, besides changes of the wall.
struct TouchNeeds {
    std::vector<ShotRequest> requests;  // sources in other sizes
    std::vector<SourceId> dismissed;    // shots that were flicked out, and nobody has undone that in time
    std::optional<PlacedShot> whole{};  // begins to become as large as the screen; its place there
    bool is_whole_over = false;         // it begins to return, or is gone
};

/// Visitors' touches on the shots of a wall, several at once (docs/technician.md, "Touch"). A touched shot is
/// lifted: it is drawn above the wall and follows its finger at once. Its place on the wall follows later,
/// and the others make way. Source: Dynamic Media Assemblage, chapter 4 and fig. 4.1; the rest is ours.
class WallTouch {
  public:
    explicit WallTouch(const TouchRules& rules) : rules_(rules), hint_(rules.hint) {}

    void handle_gesture(const Gesture& gesture, const TouchedWall& wall);

    /// Goes on to a time. Forgets what has ended, and shots that are not on the wall any more.
    /// @param may_flash  false: so soon after another change no shot becomes as large as the screen
    /// @return true: a shot begins to become as large as the screen, or to return
    bool advance(std::chrono::nanoseconds now, const TouchedWall& wall, bool may_flash);

    /// Puts all shots down where they are, because the wall changes.
    void put_all_down();

    /// True while anything is not as it was, or is offered.
    bool is_active() const { return lifted_.is_active() || tapped_ != 0 || !asked_.empty(); }

    /// The next change of the wall. None: the wall is as is wished.
    std::optional<TouchedWay> next_way(const TouchedWall& wall);

    /// Call when the wall has taken the way that was asked for.
    void way_taken(const WallWay& way, const TouchedWall& wall);

    /// The shot that a finger at this point would touch. nullptr: there is none.
    const PlacedShot* shot_at(Vec2 point, const TouchedWall& wall) const;

    /// The shots to be drawn above the wall, while what waits is dim.
    const LiftedShots& lifted() const { return lifted_; }

    /// The needs since the last call.
    TouchNeeds take_needs() { return std::exchange(needs_, {}); }

  private:
    void tap(const Gesture& gesture, SourceId source, const TouchedWall& wall);
    void drag(const Gesture& gesture, SourceId source, const TouchedWall& wall);
    bool is_for_shot(SourceId source);
    void hold(const Gesture& gesture, SourceId source, const TouchedWall& wall);
    void show_large(Lifted& lifted, const Placement& at, double dims);
    void end_drag(const Gesture& gesture, const TouchedWall& wall);
    Lifted* lift(SourceId source, std::uint64_t touch, LiftedState state, const TouchedWall& wall);
    void bring_back(Lifted& lifted);
    void change_whole(const TouchedWall& wall);
    std::vector<Wish> wishes(const TouchedWall& wall) const;

    TouchRules rules_;
    TouchHint hint_;
    LiftedShots lifted_;
    SourceId tapped_ = 0;  // shall be as large as the screen; large in its place while others hold shots
    std::chrono::nanoseconds tapped_at_{0};
    Vec2 tapped_place_;                    // canvas px
    SourceId whole_ = 0;                   // is as large as the screen
    std::map<SourceId, Placement> homes_;  // where all stood before the first touch; empty: as they are
    std::vector<Wish> asked_;              // wishes of the last way
    std::chrono::nanoseconds takes_{0};    // of the last way
    std::map<SourceId, std::chrono::nanoseconds> above_;  // until when shots' cells lie above the others'
    std::chrono::nanoseconds now_{0};
    TouchNeeds needs_;
};

}  // namespace vitrine::player
