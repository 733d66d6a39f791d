#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/layout/plan/ribbon.hpp"
#include "player/scene/pan/panning_shots.hpp"
#include "player/scene/show.hpp"
#include "player/scene/wall_shot.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine::player {

struct RibbonSettings {
    ShotOrder order = ShotOrder::shuffle;
    std::uint64_t seed = 1;
    int items_a_screen = 12;
    CellStyle cells;
    SourceId last_source = 0;  // sources are numbered from here on, apart from those of other walls
};

/// The places of a view on a ribbon: its left edge, ribbon px.
struct ViewRange {
    double first = 0;
    double last = 0;
};

/// The shots that are laid out along a ribbon, ahead of a view and a screen's width behind it, and their
/// sources. Nothing in view ever moves against its neighbours.
class RibbonShots {
  public:
    RibbonShots(Vec2 screen, const RibbonSettings& settings);

    /// Gives up all that is laid out.
    void set_screen(Vec2 screen);

    /// Updates the files, and the shots' places in the store.
    void set_files(const RecordList& records, const ShowHints& hints);

    bool has_files() const { return !coming_.is_empty(); }

    /// True if there are shots in view, and none of them is of a file that may be shown.
    bool is_outdated(double view) const;

    /// Begins anew with the next shots. @return  all that was laid out; it keeps its sources
    RibbonShots leave();

    /// The plan of more shots, if the view comes near the end. None: there are enough, or no files.
    std::optional<WallPlan> extend(double view);

    /// Takes the layout of the last plan. It changes origin().
    void set_layout(const Layout& layout);

    /// Gives up the plan under way; the next one has the same shots.
    void give_up_plan() { extension_.reset(); }

    void source_ready(SourceId source);
    void source_failed(SourceId source);

    /// The shots in view whose sources are ready, px from origin().
    std::vector<PlacedShot> seen(double view) const;

    /// The shots whose sources are ready, in view or not, px from origin().
    std::vector<const PlacedShot*> ready() const;

    /// Those, and the shots whose sources are awaited.
    std::vector<const PlacedShot*> coming() const;

    /// Starts the time of the shots in view: that of one that comes in by itself at the moment when it does.
    /// @param speed  at which the view has come here by itself, px a second
    /// @return false: one of them has no source yet
    bool show(double view, double speed, std::chrono::nanoseconds now);

    /// The views around this one in which no shot awaits its source.
    ViewRange reach(double view) const;

    /// Asks for the sources of shots that come into view soon, and gives those up that are far from it.
    /// @param goes_back  true: the view may move to the left, too
    void ask_and_retire(double view, bool goes_back, WallStep& step);

    /// The origin of the px of shots and cells, in ribbon px.
    double origin() const { return origin_; }

  private:
    enum class Source { unasked, asked, ready, failed };

    struct Shown {
        PlacedShot placed;  // in px from origin_
        Source source = Source::unasked;
        Box bounds;  // the cell's bounds, ribbon px
    };

    void drop_passed(double view);
    bool is_in_view(const Shown& shown, double view) const;

    RibbonSettings settings_;
    PanningShots coming_;
    Ribbon ribbon_;
    std::vector<Shown> shots_;           // one for each item of the ribbon
    std::vector<ShotRequest> restored_;  // for shots whose place in the store has changed
    std::vector<SourceId> left_;         // sources of shots that were given up, to be retired
    std::optional<RibbonExtension> extension_;
    std::vector<WallShot> newcomers_;  // the shots of the extension, or of the next one
    double begin_ = 0;                 // ribbon px; the view goes back no farther
    double origin_ = 0;                // ribbon px
    std::uint64_t generation_ = 0;
};

}  // namespace vitrine::player
