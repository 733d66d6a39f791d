#pragma once

#include "player/scene/change_pace.hpp"
#include "player/scene/pan/pan_course.hpp"
#include "player/scene/pan/pan_motion.hpp"
#include "player/scene/pan/ribbon_shots.hpp"
#include "player/scene/show.hpp"
#include "player/scene/wall_touch.hpp"

#include <chrono>
#include <optional>
#include <vector>

namespace vitrine::player {

struct PanSettings {
    RibbonSettings ribbon;
    double speed = 30;                                         // canvas px a second
    std::chrono::nanoseconds idle = std::chrono::seconds(30);  // then a shot that was enlarged returns
};

/// The parts from which a panning wall draws. Lent until the wall's next call.
struct PanParts {
    std::vector<const PlacedShot*> shots;   // that are ready, in view or not, px from `origin`
    std::vector<const PlacedShot*> coming;  // those, and others whose sources are awaited
    double origin = 0;                      // ribbon px
    PanCourse course;
    bool is_in_hand = false;  // a finger moves the view, or has flung it
    bool has_files = false;
    const LiftedShots& lifted;
};

/// A wall that passes by slowly, for more shots than fit on the screen. Shots are laid out ahead of the view.
/// Their sources are asked for shortly before they come into view, and retire once they have left it. The
/// view waits for sources that are late.
///
/// A finger drags and flings the view, up to a screen's width back. It stands still while a shot is enlarged.
/// Where no file in view may be shown any more, as a notice covers it, the wall fades to shots that may.
/// Where the canvas changes, it fades to the next shots. The first ones fade in over the idle picture.
class PanningWall final : public Show {
  public:
    PanningWall(const Canvas& canvas, const PanSettings& settings);

    void set_canvas(const Canvas& canvas) override;
    using Show::set_catalogue;
    void set_catalogue(const RecordList& records, const ShowHints& hints) override;
    void set_layout(const Layout& layout) override;

    void source_ready(SourceId source) override { shots_.source_ready(source); }

    void source_failed(SourceId source, std::chrono::nanoseconds now) override;
    void handle_gesture(const Gesture& gesture) override;
    std::optional<SeenShot> shot_at(Vec2 point) const override;

    /// A paused wall moves with a finger only; it has no turns and no pins.
    void set_controls(const ShowControls& controls) override { motion_.set_paused(controls.is_paused); }

    ChangePace* pace() override { return &pace_; }

    WallStep step(std::chrono::nanoseconds now) override;
    std::vector<SlotShot> standing() const override;

    /// Left edge of the view, px from the wall's start.
    double view() const { return view_; }

    /// The parts as the last step has left them.
    PanParts parts() const;

  private:
    TouchedWall touched(const std::vector<PlacedShot>& seen) const;
    void follow_touch(std::chrono::nanoseconds now, WallStep& step);
    void advance(std::chrono::nanoseconds now);
    PanCourse course() const;
    void leave_outdated();
    void draw_leaving(std::chrono::nanoseconds now, WallStep& step);

    /// The shots that were in view. They are drawn until the fade to the shots that come is over.
    struct Leaving {
        std::optional<RibbonShots> shots = {};      // none: there were no shots
        double view = 0;                            // ribbon px of these shots
        Placement place = {};                       // of the canvas as it was then, on that of today
        std::chrono::nanoseconds waiting_since{0};  // for the shots that come
        std::optional<std::chrono::nanoseconds> fading = {};  // its begin; none: it has not begun
    };

    Canvas canvas_;
    RibbonShots shots_;
    std::optional<Leaving> leaving_;
    double view_ = 0;          // ribbon px
    bool is_waiting_ = false;  // for the source of a shot in view
    std::chrono::nanoseconds now_{0};
    PanMotion motion_;
    WallTouch touch_;  // in the px of shots_
    ChangePace pace_{flash_spacing};
};

}  // namespace vitrine::player
