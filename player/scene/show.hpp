#pragma once

#include "player/input/gesture.hpp"
#include "player/layout/plan/plan_request.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/shot_rotation.hpp"
#include "player/scene/show_controls.hpp"
#include "player/scene/show_files.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// A layout that is asked for.
struct WallPlan {
    std::uint64_t generation = 0;  // to be handed back with the layout
    Vec2 canvas;                   // px
    std::vector<PlanItem> items;   // each where it stands now, or with the seat of
                                   // its slot's last shot
};

/// The work of one frame, beside drawing it.
struct WallStep {
    Frame frame;
    std::optional<WallPlan> plan;       // replaces a plan under way
    std::vector<ShotRequest> requests;  // new sources, or other sizes of those that play
    std::vector<SourceId> retired;      // sources that are neither in this frame nor in a later one
};

/// A shot on the wall and its slot.
struct SlotShot {
    int slot = 0;  // on a panning wall the position from the left, which changes
                   // as it moves
    ShotKey key;
};

/// Something that a stage shows over time: a wall or a panning wall. Knows no
/// clock: it is told of events, and step() returns what follows.
class Show {
  public:
    Show() = default;
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;
    Show(Show&&) = default;
    Show& operator=(Show&&) = default;
    virtual ~Show() = default;

    /// The screen mode has changed.
    virtual void set_canvas(Vec2 canvas) = 0;

    /// @param hints  how long files stay and how often they come
    virtual void set_catalogue(const RecordList& records, const ShowHints& hints) = 0;

    /// Sets files without hints.
    void set_catalogue(const RecordList& records) { set_catalogue(records, {}); }

    /// Takes the layout of a plan of this show, in the order of its items;
    /// ignores that of an outdated plan. It may be final, or another one follows.
    /// @pre one placement for each item of the plan
    virtual void set_layout(const Layout& layout) = 0;

    virtual void source_ready(SourceId source) = 0;

    virtual void source_failed(SourceId source, std::chrono::nanoseconds now) = 0;

    /// Follows a visitor's gesture, canvas px. A show that cannot be touched
    /// ignores it.
    virtual void handle_gesture(const Gesture& /*gesture*/) {}

    /// The shot that is seen at a canvas point; none: no shot, or the show cannot
    /// be touched.
    virtual std::optional<ShotKey> shot_at(Vec2 /*point*/) const { return std::nullopt; }

    /// Sets the operator's controls. A show without turns ignores those of turns
    /// and pins.
    virtual void set_controls(const ShowControls& /*controls*/) {}

    /// @param now  since the player's start; never goes back
    virtual WallStep step(std::chrono::nanoseconds now) = 0;

    /// Number of shots on the screen.
    virtual std::size_t count() const = 0;

    /// The shots on the screen.
    virtual std::vector<SlotShot> standing() const { return {}; }
};

}  // namespace vitrine::player
