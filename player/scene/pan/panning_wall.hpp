#pragma once

#include "player/layout/plan/ribbon.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/pan/panning_shots.hpp"
#include "player/scene/show.hpp"
#include "player/scene/wall_shot.hpp"

#include <vector>

namespace vitrine::player {

struct PanSettings {
    ShotOrder order = ShotOrder::shuffle;
    std::uint64_t seed = 1;
    int items_a_screen = 12;
    double speed = 30;  // canvas px a second
    CellStyle cells;
    SourceId last_source = 0;  // its sources are numbered from here on, apart from those of other walls
};

/// A wall that passes by slowly, for more shots than fit on the screen. Shots are laid out ahead of the view.
/// Their sources are asked for shortly before they come into view, and retire once they have left it. Nothing
/// in view ever moves against its neighbours. The view waits for sources that are late.
class PanningWall final : public Show {
  public:
    PanningWall(Vec2 canvas, const PanSettings& settings);

    void set_canvas(const Canvas& canvas) override;
    using Show::set_catalogue;
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;
    void set_layout(const Layout& layout) override;
    void source_ready(SourceId source) override;
    void source_failed(SourceId source, std::chrono::nanoseconds now) override;

    /// A paused wall stands still; it has no turns and no pins.
    void set_controls(const ShowControls& controls) override { is_paused_ = controls.is_paused; }

    WallStep step(std::chrono::nanoseconds now) override;
    std::vector<SlotShot> standing() const override;

    /// Left edge of the view, px from the wall's start.
    double view() const { return view_; }

  private:
    enum class Source { unasked, asked, ready, failed, retired };

    struct Shown {
        PlacedShot placed;  // in px from base_
        Source source = Source::unasked;
        Box bounds;  // the cell's bounds, ribbon px
    };

    void drop_passed();
    bool is_on_wall(const ShotKey& key) const;
    std::optional<WallPlan> extend();
    bool is_in_view(const Shown& shown) const;
    void advance(std::chrono::nanoseconds now);
    void ask_and_retire(WallStep& step);

    PanSettings settings_;
    Vec2 canvas_;
    PanningShots coming_;
    Ribbon ribbon_;
    std::vector<Shown> shots_;    // one for each item of the ribbon
    std::vector<SourceId> left_;  // sources of a wall that was given up, to be retired
    std::optional<RibbonExtension> extension_;
    std::vector<WallShot> newcomers_;  // the shots of the extension
    double view_ = 0;                  // ribbon px
    double base_ = 0;                  // origin of the cells' px, in ribbon px
    std::optional<std::chrono::nanoseconds> last_;
    bool is_paused_ = false;
    std::uint64_t generation_ = 0;
};

}  // namespace vitrine::player
