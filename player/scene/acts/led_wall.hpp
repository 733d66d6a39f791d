#pragma once

#include "player/scene/acts/wall_act.hpp"
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

/// The messages that the other boxes must get.
struct LedNews {
    std::optional<WallAct> act;          // the newest; its generation counts the acts
    std::optional<WallAct> preparation;  // the wall that comes next; its generation counts the preparations
    LiftedMoment lifted = {};            // what hands hold above the wall now
    std::chrono::nanoseconds now{0};     // the wall's time
};

/// The facts that the other boxes tell: what they have, and what they lack.
struct LedOthers {
    std::optional<std::uint64_t> ready;  // they have all prepared walls up to this number: the next change
                                         // comes when its wall is among them, or after five seconds. None:
                                         // nobody is waited for
    bool needs_act = false;              // the act under way is wanted once more, with a number of its own
};

/// The wall of the box that leads a wall of several boxes. It is a Wall, and makes acts of its changes: each
/// when the change is decided, which is `lead` before it begins. Before that it tells which shots come, and
/// waits a while until the other boxes have them, too.
class LedWall final : public Show {
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

    LedWall* led() override { return this; }

    /// Tells which prepared walls the other boxes have.
    void heed(const LedOthers& others);

    /// The news since the last call.
    LedNews take_news();

    /// Sets the parts of the canvas that outputs show, by BOX/OUTPUT.
    void set_parts(std::map<std::string, ActPart> parts);

  private:
    bool waits_for_others() const;
    void make_news();

    WallSettings settings_;
    Wall wall_;
    std::map<std::string, ActPart> parts_;
    std::chrono::nanoseconds now_{0};
    std::optional<std::uint64_t> others_ready_;
    std::set<SourceId> held_;            // sources that are ready here and perhaps not elsewhere
    std::uint64_t prepared_change_ = 0;  // generation of the wall's change
    std::uint64_t preparations_ = 0;
    std::chrono::nanoseconds prepared_{0};  // when the last one was made
    std::optional<WallAct> preparation_;
    std::uint64_t told_change_ = 0;  // generation of the wall's change; 0: none
    bool is_told_ = true;
    std::uint64_t acts_ = 0;
    std::optional<WallAct> act_;
};

}  // namespace vitrine::player
