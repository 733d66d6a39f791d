#pragma once

#include "player/scene/acts/act_of_wall.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/scene/wall.hpp"

#include <chrono>
#include <cstdint>

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
        : style_(settings.transition), wall_(canvas, settings) {}

    using Show::set_catalogue;

    void set_catalogue(const RecordList& records, const ShowHints& hints) override;

    bool is_changing() const override { return is_in_change(wall_); }

    WallParts parts() const { return wall_.parts(); }

  private:
    Show& inner() override { return wall_; }

    const Show& inner() const override { return wall_; }

    void make_news() override;

    LiftedMoment lifted() const override { return lifted_moment(wall_.parts(), now()); }

    TransitionStyle style_;
    Wall wall_;
    std::uint64_t prepared_change_ = 0;  // generation of the wall's change
    std::uint64_t told_change_ = 0;      // generation of the wall's change; 0: none
};

}  // namespace vitrine::player
