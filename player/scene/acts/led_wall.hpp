#pragma once

#include "player/scene/acts/awaited_sources.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/scene/wall.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// A Wall that leads a wall of several boxes. It makes acts of its changes: each when the change is decided,
/// which is `lead` before it begins.
class LedWall final : public LedShow {
  public:
    /// The time from the decision of a change to its begin. A connection may be cut for a second meanwhile.
    static constexpr std::chrono::nanoseconds lead = std::chrono::milliseconds(1250);
    static constexpr std::chrono::nanoseconds touch_lead = std::chrono::milliseconds(60);

    /// @param settings  with a lead
    LedWall(const Canvas& canvas, const WallSettings& settings)
        : settings_(settings), wall_(canvas, settings) {}

    void set_canvas(const Canvas& canvas) override { wall_.set_canvas(canvas); }

    using Show::set_catalogue;

    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    void set_layout(const Layout& layout) override { wall_.set_layout(layout); }

    void source_ready(SourceId source) override;

    void source_failed(SourceId source, std::chrono::nanoseconds now) override {
        wall_.source_failed(source, now);
    }

    void handle_gesture(const Gesture& gesture) override { wall_.handle_gesture(gesture); }

    std::optional<SeenShot> shot_at(Vec2 point) const override { return wall_.shot_at(point); }

    void set_controls(const ShowControls& controls) override { wall_.set_controls(controls); }

    WallStep step(std::chrono::nanoseconds now) override;

    ChangePace* pace() override { return wall_.pace(); }

    WallParts parts() const { return wall_.parts(); }

    std::vector<SlotShot> standing() const override { return wall_.standing(); }

    std::set<std::string> avoided_files() const override { return wall_.avoided_files(); }

    void heed(const LedOthers& others) override;
    LedNews take_news() override;
    void set_parts(std::map<std::string, ActPart> parts) override;

    bool is_changing() const override { return is_in_change(wall_); }

  private:
    void make_news();

    WallSettings settings_;
    Wall wall_;
    std::map<std::string, ActPart> parts_;
    std::chrono::nanoseconds now_{0};
    AwaitedSources awaited_;
    std::uint64_t prepared_change_ = 0;  // generation of the wall's change
    std::optional<WallAct> preparation_;
    std::uint64_t told_change_ = 0;  // generation of the wall's change; 0: none
    bool is_told_ = true;
    std::uint64_t acts_ = 0;
    std::optional<WallAct> act_;
};

}  // namespace vitrine::player
