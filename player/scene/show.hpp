#pragma once

#include "player/input/gesture.hpp"
#include "player/layout/canvas.hpp"
#include "player/layout/edit/wall_way.hpp"
#include "player/layout/plan/plan_request.hpp"
#include "player/scene/arrangement.hpp"
#include "player/scene/files/shot_rotation.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/frame.hpp"
#include "player/scene/shot_request.hpp"
#include "player/scene/show_controls.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

class ChangePace;
class FollowedWall;
class LedShow;

/// A request for a layout.
struct WallPlan {
    std::uint64_t generation = 0;  // the layout must have the same
    Canvas canvas;                 // px
    std::vector<PlanItem> items;   // each at its present place, or with the seat of its slot's last shot
    std::shared_ptr<const WayRequest> way;  // instead of items: the wall is touched
    bool keeps_places = false;              // where all items have a place, that is the layout
};

/// The work of one frame, besides drawing it.
struct WallStep {
    Frame frame;
    std::optional<WallPlan> plan;       // replaces a plan under way
    std::vector<ShotRequest> requests;  // new sources, or other sizes of those that play
    std::vector<SourceId> retired;      // sources that neither this frame nor a later one needs
};

/// A shot that is seen, and its source, which is the subject of touches on it.
struct SeenShot {
    SourceId source = 0;
    ShotKey key;
};

/// A show of a stage: a wall or a panning wall. Knows no clock: events are passed in, and step() returns the
/// work that follows.
class Show {
  public:
    Show() = default;
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;
    Show(Show&&) = default;
    Show& operator=(Show&&) = default;
    virtual ~Show() = default;

    /// Call when the screen's mode has changed.
    virtual void set_canvas(const Canvas& canvas) = 0;

    /// @param hints  tell the dwell and the frequency of files
    virtual void set_catalogue(const RecordList& records, const ShowHints& hints) = 0;

    /// Sets files without hints.
    void set_catalogue(const RecordList& records) { set_catalogue(records, {}); }

    /// Takes the layout of a plan of this show, in the order of the plan's items. Ignores the layout of an
    /// outdated plan. After a layout that is not final another one follows.
    /// @pre one placement for each item of the plan
    virtual void set_layout(const Layout& layout) = 0;

    virtual void source_ready(SourceId source) = 0;

    virtual void source_failed(SourceId source, std::chrono::nanoseconds now) = 0;

    /// Handles a visitor's gesture, canvas px. A show that cannot be touched ignores it.
    virtual void handle_gesture(const Gesture& /*gesture*/) {}

    /// The shot that is seen at a canvas point. None: no shot is there, or the show cannot be touched.
    virtual std::optional<SeenShot> shot_at(Vec2 /*point*/) const { return std::nullopt; }

    /// Sets the operator's controls. A show without turns ignores turns and pins.
    virtual void set_controls(const ShowControls& /*controls*/) {}

    /// @param now  since the player's start; never goes back
    virtual WallStep step(std::chrono::nanoseconds now) = 0;

    /// The pace of the show's changes, for what changes the picture besides. nullptr: the show only moves
    /// slowly.
    virtual ChangePace* pace() { return nullptr; }

    /// The show as one that leads a wall of several boxes, or follows. nullptr: it does not.
    virtual LedShow* led() { return nullptr; }

    virtual FollowedWall* followed() { return nullptr; }

    /// The folder that a visitor looks into; empty: none.
    virtual std::string opened_folder() const { return {}; }

    /// The shots on the screen.
    virtual std::vector<SlotShot> standing() const = 0;

    std::size_t count() const { return standing().size(); }

    /// Paths of the files that the show leaves out for a while: their sources failed, or a visitor dismissed
    /// them and no other shot was there.
    virtual std::set<std::string> avoided_files() const { return {}; }
};

}  // namespace vitrine::player
