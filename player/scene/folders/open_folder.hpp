#pragma once

#include "player/scene/folders/back_mark.hpp"
#include "player/scene/folders/standing_names.hpp"
#include "player/scene/wall.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// The wall of one folder while visitors look into it or into one of its sub-folders. Its clock stands still
/// while another wall covers it. A wall that is covered can do without its sources for a while.
class OpenFolder {
  public:
    /// @param folder  below the media folder; empty: all
    OpenFolder(std::string folder, const Canvas& canvas, const WallSettings& settings);

    const std::string& folder() const { return folder_; }

    Wall& wall() { return *wall_; }

    const Wall& wall() const { return *wall_; }

    void set_canvas(const Canvas& canvas) {
        canvas_ = canvas;
        wall_->set_canvas(canvas);
    }

    /// Lets no change of the wall begin, or lets them begin again.
    void hold(bool is_held);

    void set_controls(const ShowControls& controls);

    /// The clock stands still from here on.
    void cover(std::chrono::nanoseconds now);

    /// The clock goes on.
    void uncover(std::chrono::nanoseconds now);

    /// The next step; while it is covered, the frame of the last one.
    WallStep step(std::chrono::nanoseconds now);

    /// The frame of the last step.
    const Frame& frame() const { return frame_; }

    /// @param now  of the player; @return the same on the clock of this wall
    std::chrono::nanoseconds local(std::chrono::nanoseconds now) const {
        return covered_.value_or(now) - away_;
    }

    /// The time on the clock of this wall at which it stands; none: it goes.
    std::optional<std::chrono::nanoseconds> stands_at() const {
        return covered_ ? std::optional(*covered_ - away_) : std::nullopt;
    }

    /// Does without all sources. @return those that it had
    std::vector<SourceId> release_sources();

    /// Asks for the sources of the standing wall again.
    std::vector<ShotRequest> ask_again();

    /// The place of the way back on this wall, canvas px.
    Box way_back() const { return moved(back_mark(canvas_), way_back_.offset); }

    /// Adds the place of the way back to a plan of this wall.
    void keep_way_back_free(WallPlan& plan) const;

    /// Takes the layout of such a plan.
    void set_layout(const Layout& layout);

    /// A source is ready or has failed.
    void source_answered(SourceId source) { missing_.erase(source); }

    /// True: no source of those that were asked for again is missing.
    bool has_sources() const { return missing_.empty(); }

  private:
    std::string folder_;
    Canvas canvas_;
    Placement way_back_;  // moves it from its first place
    std::unique_ptr<Wall> wall_;
    ShowControls controls_;
    bool is_held_ = false;
    Frame frame_;
    StandingNames names_;                              // of the sub-folders
    std::chrono::nanoseconds away_{0};                 // for which the clock has stood still
    std::optional<std::chrono::nanoseconds> covered_;  // since then the clock stands still
    std::set<SourceId> sources_;                       // that were asked for
    std::set<SourceId> missing_;                       // that were asked for again, and have not answered
};

}  // namespace vitrine::player
