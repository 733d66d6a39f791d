#pragma once

#include "player/scene/acts/led_show.hpp"
#include "player/scene/pan/panning_wall.hpp"

#include <optional>
#include <set>

namespace vitrine::player {

/// A PanningWall that leads a wall of several boxes. An act of it tells the shots along the wall and the way
/// of the view, which the others follow by themselves. So one is made only if shots come, or if the view does
/// not go on as it was told. While a finger moves the view, each frame tells where it is (LiftedMoment).
class LedPanningWall final : public LedShow {
  public:
    LedPanningWall(const Canvas& canvas, const PanSettings& settings)
        : cells_(settings.ribbon.cells), canvas_(canvas), wall_(canvas, settings) {}

    void set_canvas(const Canvas& canvas) override;

    /// The view goes on all the time, and a jump of the clock moves it by a few px.
    bool is_changing() const override { return false; }

  private:
    Show& inner() override { return wall_; }

    const Show& inner() const override { return wall_; }

    void make_news() override;
    LiftedMoment lifted() const override;
    void prepare_coming(const PanParts& parts);
    bool is_told(const PanParts& parts) const;

    CellStyle cells_;
    Canvas canvas_;
    PanningWall wall_;
    std::set<SourceId> prepared_;  // that the last preparation names
    std::optional<WallAct> told_;  // the last act
};

}  // namespace vitrine::player
