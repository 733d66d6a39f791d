#pragma once

#include "player/scene/acts/awaited_sources.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/scene/pan/panning_wall.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::player {

/// A PanningWall that leads a wall of several boxes. An act of it tells the shots along the wall and the way
/// of the view, which the others follow by themselves. So one is made only if shots come, or if the view does
/// not go on as it was told. While a finger moves the view, each frame tells where it is (LiftedMoment).
class LedPanningWall final : public LedShow {
  public:
    LedPanningWall(const Canvas& canvas, const PanSettings& settings)
        : cells_(settings.ribbon.cells), canvas_(canvas), wall_(canvas, settings) {}

    void set_canvas(const Canvas& canvas) override;

    using Show::set_catalogue;

    void set_catalogue(const RecordList& records, const ShowHints& hints) override {
        wall_.set_catalogue(records, hints);
    }

    void set_layout(const Layout& layout) override { wall_.set_layout(layout); }

    void source_ready(SourceId source) override;

    void source_failed(SourceId source, std::chrono::nanoseconds now) override {
        wall_.source_failed(source, now);
    }

    void handle_gesture(const Gesture& gesture) override { wall_.handle_gesture(gesture); }

    std::optional<SeenShot> shot_at(Vec2 point) const override { return wall_.shot_at(point); }

    void set_controls(const ShowControls& controls) override { wall_.set_controls(controls); }

    ChangePace* pace() override { return wall_.pace(); }

    WallStep step(std::chrono::nanoseconds now) override;

    std::vector<SlotShot> standing() const override { return wall_.standing(); }

    void heed(const LedOthers& others) override;
    LedNews take_news() override;
    void set_parts(std::map<std::string, ActPart> parts) override;

    /// The view goes on all the time, and a jump of the clock moves it by a few px.
    bool is_changing() const override { return false; }

  private:
    void prepare(const PanParts& parts);
    bool is_told(const PanParts& parts) const;
    WallAct act_of(const PanParts& parts) const;

    CellStyle cells_;
    Canvas canvas_;
    PanningWall wall_;
    std::map<std::string, ActPart> parts_;
    std::chrono::nanoseconds now_{0};
    AwaitedSources awaited_;
    std::set<SourceId> prepared_;  // that the last preparation names
    std::optional<WallAct> preparation_;
    bool must_tell_ = false;
    std::optional<WallAct> told_;  // the last act
    std::optional<WallAct> act_;
};

}  // namespace vitrine::player
