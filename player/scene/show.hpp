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

/// What is to be laid out.
struct WallPlan {
    std::uint64_t generation = 0;  // to be handed back with the layout
    Vec2 canvas;                   // px
    std::vector<PlanItem> items;   // each where it stands now, or with the seat of its slot's last shot
};

/// What is to be done in this frame, beside drawing it.
struct WallStep {
    Frame frame;
    std::optional<WallPlan> plan;       // replaces a plan still under way
    std::vector<ShotRequest> requests;  // new sources, or another size for one that plays
    std::vector<SourceId> retired;      // not in this frame and never again
};

/// A shot and where it stands.
struct SlotShot {
    int slot = 0;  // of a wall that pans counted from the left, and different soon
    ShotKey key;
};

/// What is on the screen, from wish to picture. Knows no clock: events are told to it, step() says what
/// follows.
class Show {
  public:
    Show() = default;
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;
    Show(Show&&) = default;
    Show& operator=(Show&&) = default;
    virtual ~Show() = default;

    /// Another screen mode.
    virtual void set_canvas(Vec2 canvas) = 0;

    /// @param hints  how some of them are shown
    virtual void set_catalogue(const RecordList& records, const ShowHints& hints) = 0;

    /// Nothing is said of any of them.
    void set_catalogue(const RecordList& records) { set_catalogue(records, {}); }

    /// A layout of a plan of this show, in the order of its items; of an outdated plan it is ignored. It may
    /// be final, or another follows.
    /// @pre one placement for each item of the plan
    virtual void set_layout(const Layout& layout) = 0;

    virtual void source_ready(SourceId source) = 0;

    virtual void source_failed(SourceId source, std::chrono::nanoseconds now) = 0;

    /// What a visitor does, canvas px. A show that cannot be touched ignores it.
    virtual void handle_gesture(const Gesture& /*gesture*/) {}

    /// The shot that is seen at a canvas point; none: none, or one that cannot be touched.
    virtual std::optional<ShotKey> shot_at(Vec2 /*point*/) const { return std::nullopt; }

    /// What holds from now on; a show that has no turns ignores what concerns them.
    virtual void set_controls(const ShowControls& /*controls*/) {}

    /// @param now  since the player's start; never goes back
    virtual WallStep step(std::chrono::nanoseconds now) = 0;

    /// How many shots are on the screen.
    virtual std::size_t count() const = 0;

    /// Each of them.
    virtual std::vector<SlotShot> standing() const { return {}; }
};

}  // namespace vitrine::player
